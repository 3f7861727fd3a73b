// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <QDialog>

#include "app/gui/base/page.h"
#include "app/services/people/people_service.h"
#include "app/services/study/campaign_service.h"

class QLabel;
class QPushButton;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QPlainTextEdit;
class QVBoxLayout;

namespace torsio::gui {

class DataTable;
class PageHeading;

/// Nine-index evaluations of tissue models: raters and progress.
class CampaignsPage : public Page {
  Q_OBJECT

 public:
  explicit CampaignsPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  bool add(const CampaignPlan& plan);

 private:
  void read();
  void showContent();
  void showRaters();
  void askNew();

  std::vector<CampaignRow> rows_;
  PageHeading* heading_;
  QPushButton* add_;
  DataTable* table_;
  QLabel* ratersTitle_;
  DataTable* raters_;
};

class FieldChecks;

/// A new evaluation: name, models, weights of indices and classes (initially the paper's), raters.
class CampaignDialog : public QDialog {
  Q_OBJECT

 public:
  /// `recordings`: those that raters may see. `assets`: folder of the scenes, for their titles.
  CampaignDialog(const std::vector<PersonRow>& raters, std::vector<EvaluationRecording> recordings,
                 const std::filesystem::path& assets, QWidget* parent);

  [[nodiscard]] CampaignPlan plan() const;

 private:
  void fillRecordings(const std::filesystem::path& assets);
  void fillRaters(const std::vector<PersonRow>& raters);
  QWidget* weightFields();
  void addChecks(QFormLayout* form, QVBoxLayout* left);
  [[nodiscard]] QString wrongModels() const;
  [[nodiscard]] QString wrongRaters() const;
  void countRaters();
  /// Lists the models of the chosen recordings, each with its recording.
  void takeRecordings();
  [[nodiscard]] static QString modelName(TissueModel model);

  EvaluationInstrument instrument_;
  QLineEdit* name_;
  QPlainTextEdit* models_;
  std::vector<QDoubleSpinBox*> indexWeights_;
  std::vector<QDoubleSpinBox*> classWeights_;
  QLabel* indexSum_;
  QLabel* classSum_;
  QLabel* chosen_;
  std::map<QString, std::string> classOf_;  // rater class by rater id
  DataTable* raters_;
  std::vector<EvaluationRecording> choice_;
  DataTable* recordings_;
  QDialogButtonBox* buttons_;
  FieldChecks* checks_;
};

}  // namespace torsio::gui
