// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "app/services/training/debrief.h"
#include "assessment/attempt/pass_rule.h"
#include "sim/core/text.h"

namespace torsio {

// What a debrief says, the same in the window and in a browser. Values come in SI and leave in the units of a
// ward.

/// "Overshoot"; the title of its card for a metric that has no shorter name.
[[nodiscard]] Text metricName(const std::string& id);
/// What SI times this is the shown unit.
[[nodiscard]] double metricScale(const std::string& id);
/// "\u00b0", "mm"; empty for a mere number.
[[nodiscard]] std::string metricUnit(const std::string& id);
/// How many decimals of that unit are shown.
[[nodiscard]] int metricDecimals(const std::string& id);
/// "12.4 s", "3.1\u00b0", "62 %"; "yes" and "no" of a metric that answers a question.
[[nodiscard]] Text quantityText(const std::string& metric, double value);
/// One line of what was asked for. `twists`: completed ones.
[[nodiscard]] Text checkText(const TargetCheck& check, std::size_t twists);
/// What was good or bad, in one sentence.
[[nodiscard]] Text findingText(const DebriefFinding& finding, bool strength);
/// What to try next; empty for a metric without advice.
[[nodiscard]] Text adviceText(const std::string& metric);

}  // namespace torsio
