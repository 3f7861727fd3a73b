// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QString>

#include "app/study/cohort_service.h"

class QWidget;

namespace torsio::gui {

/// Name of a kind of time ("virtual", "real", "rest") or deviation in the user's language.
[[nodiscard]] QString exposureName(const std::string& kind);
[[nodiscard]] QString deviationName(const std::string& kind);

/// Minutes on the real arm, on the simulator or resting. Cohort, enrolment and start are the caller's. Empty:
/// given up.
[[nodiscard]] std::optional<NewExposure> askExposure(QWidget* parent, const QString& trainee);
/// What did not go by the protocol. The same.
[[nodiscard]] std::optional<NewDeviation> askDeviation(QWidget* parent, const QString& trainee);

/// Who takes whose turn, and why.
struct Swap {
  std::string enrolmentId{};  ///< of the other
  std::string reason{};
};
/// `others`: enrolments and codes to choose from. Empty: given up.
[[nodiscard]] std::optional<Swap> askSwap(QWidget* parent, const QString& trainee,
                                          const std::vector<std::pair<std::string, QString>>& others);

}  // namespace torsio::gui
