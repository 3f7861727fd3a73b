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

/// Name of a kind of deviation in the user's language.

/// Minutes on the real arm, on the simulator or resting; `unplanned`: codes of those among the trainees whose
/// arm spends no time on it, which needs a reason. Cohort, enrolment and start are the caller's. Empty: given
/// up.
[[nodiscard]] std::optional<NewExposure> askExposure(QWidget* parent, const QString& trainee,
                                                     const std::map<ExposureKind, QStringList>& unplanned);
/// What did not go by the protocol. The same.
[[nodiscard]] std::optional<NewDeviation> askDeviation(QWidget* parent, const QString& trainee);

/// Who takes whose turn, and why.
struct Swap {
  EnrolmentId enrolmentId{};  ///< of the other
  std::string reason{};
};
/// `others`: enrolments and codes to choose from. Empty: given up.
[[nodiscard]] std::optional<Swap> askSwap(QWidget* parent, const QString& trainee,
                                          const std::vector<std::pair<std::string, QString>>& others);

}  // namespace torsio::gui
