// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <QString>

#include "app/services/study/scoring_plan.h"
#include "assessment/domain/rating/sheet_state.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/occasion.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio::gui {

// Codes of the record in the user's language; an unknown code is shown as it is, an empty one as a dash.

/// "half-way"; occasions that a centre added are called as it named them.
[[nodiscard]] QString occasionName(const Occasion& occasion);
[[nodiscard]] QString factorName(const std::string& code);
[[nodiscard]] QString levelName(const std::string& code);
/// "chief physician"; classes of a centre's own keep their code.
[[nodiscard]] QString raterClassName(const std::string& code);
[[nodiscard]] QString methodName(AllocationMethod method);
[[nodiscard]] QString sheetStateName(SheetState state);

/// What a mastery rule may be about: id and name.
[[nodiscard]] std::vector<std::pair<std::string, QString>> masteryMetrics();
/// "at_least" or "at_most", as it is better, and the unit that a rule about such a metric is stored in.
[[nodiscard]] std::string metricBetter(const std::string& id);
[[nodiscard]] std::string storedUnit(const std::string& id);
/// How a value of it is shown, as everywhere else.
struct ShownMetric {
  double scale = 1.0;  ///< what is stored times this is what is shown
  int decimals = 0;
  QString suffix{};  ///< " %", "\u00b0"; empty: a mere number
};
[[nodiscard]] ShownMetric shownMetric(const std::string& id);

}  // namespace torsio::gui
