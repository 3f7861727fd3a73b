// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QDialog>

#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "assessment/domain/study/cohort.h"

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace torsio::gui {

class FieldChecks;

/// Asks for a new cohort: name, words, and the running curriculum whose arms become its groups; without one,
/// the groups by name; and what difference of scores the plan takes for none.
class CohortDialog : public QDialog {
  Q_OBJECT

 public:
  CohortDialog(const std::vector<CurriculumRow>& curricula, QWidget* parent);

  [[nodiscard]] NewCohort cohort() const;

 private:
  void check();

  QLineEdit* name_;
  QLineEdit* description_;
  QComboBox* curriculum_;
  QLineEdit* groups_;
  QLabel* groupsLabel_;
  QDoubleSpinBox* margin_;
  QDialogButtonBox* buttons_;
  FieldChecks* checks_;
};

/// Asks for another name of a cohort. Empty: given up.
[[nodiscard]] std::optional<std::string> askCohortName(QWidget* parent, const std::string& name);

/// A step in the life of a cohort, and why.
struct CohortStateChange {
  CohortState state = CohortState::kClosed;
  std::string reason{};
};
/// Asks for the next step: to close what runs; to archive what is closed, or to open it again. Empty: given
/// up.
[[nodiscard]] std::optional<CohortStateChange> askCohortState(QWidget* parent, const QString& names,
                                                              CohortState state);

/// Running versions, newest first: id and "Name, version 2".
[[nodiscard]] std::vector<std::pair<std::string, QString>> runningVersions(
    const std::vector<CurriculumRow>& curricula);
/// Asks which running curriculum to follow. Empty: given up.
[[nodiscard]] std::optional<std::string> askCurriculum(QWidget* parent, const QString& names,
                                                       const std::vector<CurriculumRow>& curricula);

}  // namespace torsio::gui
