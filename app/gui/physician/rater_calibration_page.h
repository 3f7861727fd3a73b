// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/gui/base/page.h"
#include "app/services/review/rater_calibration.h"
#include "app/services/review/sheet_editor.h"

class QLabel;
class QPushButton;
class QScrollArea;

namespace torsio::gui {

class Card;
class ChoiceRow;
class PageHeading;
class ReplayPanel;
class SheetEditorPanel;

/// Two reference runs before the real ones: score them and compare with the panel.
class RaterCalibrationPage : public Page {
  Q_OBJECT

 public:
  explicit RaterCalibrationPage(ShellContext& shell, QWidget* parent = nullptr);
  ~RaterCalibrationPage() override;

  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  [[nodiscard]] std::vector<std::pair<QString, QString>> keys() const override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void openRun(std::size_t number);
  void showRuns();
  void showResult();
  void compare();
  void goNext();
  /// Returns whether the mark on the sheet is the last one compared.
  [[nodiscard]] bool compared() const;
  /// Returns the first unscored run; 0: none.
  [[nodiscard]] std::size_t nextNumber() const;
  [[nodiscard]] QString anchorText() const;

  PageHeading* heading_;
  QPushButton* goOn_;
  ChoiceRow* choices_;
  ReplayPanel* replay_;
  SheetEditorPanel* sheet_;
  QPushButton* compare_;
  Card* resultCard_;
  QLabel* result_;
  QLabel* sum_;
  Card* rubricCard_;
  QScrollArea* anchorsArea_;
  QLabel* anchors_;
  RaterCalibration calibration_;
  std::size_t number_ = 0;
  std::uint64_t loads_ = 0;
};

}  // namespace torsio::gui
