// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QDialog>
#include <QString>

#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QWidget;
class QFormLayout;
class QSpinBox;

namespace torsio::gui {

class FieldChecks;

/// Asks for a new cohort: name, description, the running curriculum whose arms become its groups, or else the
/// names of groups; and the equivalence margin of scores.
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

/// Asks for a cohort's new name. Empty: cancelled.
[[nodiscard]] std::optional<std::string> askCohortName(QWidget* parent, const std::string& name);

/// A change of a cohort's state, with its reason.
struct CohortStateChange {
  CohortState state = CohortState::kClosed;
  std::string reason{};
};
/// Asks for the next state: close a running cohort; archive or reopen a closed one. Empty: cancelled.
[[nodiscard]] std::optional<CohortStateChange> askCohortState(QWidget* parent, const QString& names,
                                                              CohortState state);

/// Returns running versions, newest first: id and "Name, version 2".
[[nodiscard]] std::vector<std::pair<std::string, QString>> runningVersions(
    const std::vector<CurriculumRow>& curricula);
/// Asks for a running curriculum to follow. Empty: cancelled.
[[nodiscard]] std::optional<std::string> askCurriculum(QWidget* parent, const QString& names,
                                                       const std::vector<CurriculumRow>& curricula);

/// A trainee's manual move to another group.
struct GroupMove {
  GroupId groupId{};
  std::string reason{};
};
/// Asks for target group and reason. `groups`: possible targets. Empty: cancelled.
[[nodiscard]] std::optional<GroupMove> askGroupMove(QWidget* parent, const QString& codes,
                                                    const std::vector<StudyGroup>& groups);

/// Sample size calculation of a study, and the power of a given number (torsio power). GUI thread.
class PowerDialog : public QDialog {
  Q_OBJECT

 public:
  explicit PowerDialog(QWidget* parent);

 private:
  void showAnswer();
  void showAgreement();

  QComboBox* design_;
  QSpinBox* groups_;
  QDoubleSpinBox* effect_;
  QDoubleSpinBox* power_;
  QDoubleSpinBox* alpha_;
  QDoubleSpinBox* correlation_;
  QDoubleSpinBox* icc_;
  QDoubleSpinBox* width_;
  QSpinBox* raters_;
  QSpinBox* atHand_;
  QFormLayout* form_;
  QLabel* needed_;
  QLabel* shown_;
};

}  // namespace torsio::gui
