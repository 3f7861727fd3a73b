// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include <QString>
#include <QStringList>

#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"

class QWidget;

namespace torsio::gui {

/// Returns the name of a kind of deviation in the user's language.

/// Asks for minutes on the real arm, on the simulator or resting; `unplanned`: codes of the trainees whose
/// arm has no such time, which needs a reason. The caller sets cohort, enrolment and start. Empty: cancelled.
[[nodiscard]] std::optional<NewExposure> askExposure(QWidget* parent, const QString& trainee,
                                                     const std::map<ExposureKind, QStringList>& unplanned);
/// Asks for a deviation from the protocol. The caller sets cohort, enrolment and start. Empty: cancelled.
[[nodiscard]] std::optional<NewDeviation> askDeviation(QWidget* parent, const QString& trainee);

/// A swap of turns, with its reason.
struct Swap {
  EnrolmentId enrolmentId{};  ///< of the other trainee
  std::string reason{};
};
/// `others`: enrolments and codes to choose from. Empty: cancelled.
[[nodiscard]] std::optional<Swap> askSwap(QWidget* parent, const QString& trainee,
                                          const std::vector<std::pair<std::string, QString>>& others);

}  // namespace torsio::gui
