// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "assessment/attempt/measured_trial.h"
#include "assessment/metrics/detorsion.h"
#include "sim/record/trial.h"

namespace torsio {

/// Reads the rules for judging an untwisting from TrialHeader::parametersJson; empty for a recording of
/// twists, or parameters unknown to this version.
[[nodiscard]] std::optional<DetorsionRules> detorsionRulesOf(const std::string& parametersJson);

/// Adds the recording's own judging parameters to the rules of an exercise.
[[nodiscard]] AttemptRules recordedRules(AttemptRules exercise, const TrialHeader& header);

}  // namespace torsio
