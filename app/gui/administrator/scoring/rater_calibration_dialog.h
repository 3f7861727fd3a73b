// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include <QDialog>
#include <QString>
#include <QStringList>

#include "app/services/review/rater_calibration.h"
#include "app/services/study/rubric_service.h"
#include "assessment/domain/rating/rubric.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Reference runs of rater calibration: lists them, adds one with its panel's mark, withdraws one with a
/// reason. Each change is stored at once.
class RaterCalibrationDialog : public QDialog {
  Q_OBJECT

 public:
  /// `rubrics`: at least one, each with a revision.
  RaterCalibrationDialog(ShellContext& shell, std::vector<RubricRow> rubrics, QWidget* parent);

 private:
  void createForm();
  void read();
  void check();
  void add();
  /// Returns the selected runs that are not withdrawn.
  [[nodiscard]] QStringList chosenRuns() const;
  void withdraw();
  void showScale();
  [[nodiscard]] const RubricRevision& revision() const;

  ShellContext& shell_;
  std::vector<RubricRow> rubrics_;
  QLabel* state_;
  DataTable* present_;
  std::set<QString> withdrawn_;  // listed runs that are withdrawn
  DataTable* candidates_;
  QComboBox* rubric_;
  QDoubleSpinBox* mark_;
  QSpinBox* panel_;
  QPushButton* withdraw_;
  QPushButton* add_;
  QPushButton* close_;
};

}  // namespace torsio::gui
