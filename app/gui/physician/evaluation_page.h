// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/gui/base/page.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/services/review/evaluation_form.h"
#include "app/services/review/sheet_editor.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class ChoiceRow;
class PageHeading;
class ReplayPanel;
class SheetEditorPanel;

/// The nine-index form: the models one after another in this rater's random order, with hidden labels.
class EvaluationPage : public Page {
  Q_OBJECT

 public:
  explicit EvaluationPage(ShellContext& shell, QWidget* parent = nullptr);
  ~EvaluationPage() override;

  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  [[nodiscard]] std::vector<std::pair<QString, QString>> keys() const override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void customEvent(QEvent* event) override;

 private:
  [[nodiscard]] const EvaluationForm* form() const;
  [[nodiscard]] const EvaluationFormModel* model() const;
  void read();
  void openFirst();
  void openModel(std::size_t at);
  void edited();
  void submit();
  /// Loads the recording of the open model, if any.
  void openRecording();
  void showModels();
  void showAll();
  void showDefinition();
  /// What was watched of the open model.
  [[nodiscard]] WatchLog& watched();
  void keepWatched();
  void showWatched();

  PageHeading* heading_;
  QComboBox* campaigns_;
  ChoiceRow* choices_;
  QLabel* scaleText_;
  QLabel* definition_;  // definition of the current index
  SheetEditorPanel* sheet_;
  ReplayPanel* replay_;
  std::uint64_t loads_ = 0;  // id of the latest load
  SaidLine said_;
  QPushButton* submit_;
  std::vector<EvaluationForm> forms_;
  std::size_t campaign_ = 0;
  std::size_t model_ = 0;
  std::map<std::pair<CampaignId, std::string>, WatchLog> watched_;  // by campaign and hidden label
  std::map<std::pair<CampaignId, std::string>, WatchLog> kept_;     // what counts of it so far
};

}  // namespace torsio::gui
