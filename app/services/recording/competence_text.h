// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assessment/attempt/competence.h"
#include "sim/core/text.h"

namespace torsio {

// What every place says of a competence verdict, in the same words.

/// "4.9 %"; below a twentieth of a percent "below 0.1 %".
[[nodiscard]] std::string percentText(double share);

/// The whole rule: which design, what a success is, failure rates, attempts.
[[nodiscard]] Text competenceRuleText(const CompetenceRule& rule);
/// The rates of false passes, false fails and false alarms, within how many attempts.
[[nodiscard]] Text competenceErrorText(const CompetenceDesign& design, const CompetenceErrors& errors);
/// The level in a word, and in how many attempts it shows.
[[nodiscard]] Text competenceLevelText(const CompetenceVerdict& verdict);

}  // namespace torsio
