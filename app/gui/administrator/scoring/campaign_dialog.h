// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <QDialog>

#include "app/people/people_service.h"
#include "app/study/campaign_service.h"

class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace torsio::gui {

class DataTable;

/// A new evaluation: name, models, the weights of indices and classes (the paper's to begin with), raters.
class CampaignDialog : public QDialog {
  Q_OBJECT

 public:
  /// `recordings`: those that may be shown to the raters. `assets`: folder of the scenes, for their titles.
  CampaignDialog(const std::vector<PersonRow>& raters, std::vector<EvaluationRecording> recordings,
                 const std::filesystem::path& assets, QWidget* parent);

  [[nodiscard]] CampaignPlan plan() const;

 private:
  QWidget* weightFields();
  void check();
  /// Writes the models of the chosen recordings, each with its recording.
  void takeRecordings();
  [[nodiscard]] static QString modelName(TissueModel model);

  EvaluationInstrument instrument_;
  QLineEdit* name_;
  QPlainTextEdit* models_;
  std::vector<QDoubleSpinBox*> indexWeights_;
  std::vector<QDoubleSpinBox*> classWeights_;
  QLabel* sums_;
  std::map<QString, std::string> classOf_;  // of a rater's id
  DataTable* raters_;
  std::vector<EvaluationRecording> choice_;
  DataTable* recordings_;
  QDialogButtonBox* buttons_;
};

}  // namespace torsio::gui
