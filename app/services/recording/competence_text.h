// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assessment/attempt/competence.h"
#include "sim/core/text.h"

namespace torsio {

// Texts of a competence verdict, the same everywhere.

/// Returns "4.9 %"; "below 0.1 %" for less than a twentieth of a percent.
[[nodiscard]] std::string percentText(double share);

/// Describes the whole rule: design, success, failure rates, attempts.
[[nodiscard]] Text competenceRuleText(const CompetenceRule& rule);
/// Describes the rates of false passes, false fails and false alarms, and within how many attempts.
[[nodiscard]] Text competenceErrorText(const CompetenceDesign& design, const CompetenceErrors& errors);
/// Names the level, and the number of attempts that it is based on.
[[nodiscard]] Text competenceLevelText(const CompetenceVerdict& verdict);

}  // namespace torsio
