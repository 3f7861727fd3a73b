// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "assessment/attempt/measured_trial.h"
#include "assessment/metrics/detorsion.h"
#include "sim/record/trial.h"

namespace torsio {

/// Reads by what an untwisting is judged out of TrialHeader::parametersJson; empty of a recording that is to
/// be twisted, or of parameters that this version does not know.
[[nodiscard]] std::optional<DetorsionRules> detorsionRulesOf(const std::string& parametersJson);

/// Adds to the rules of an exercise what the recording itself says about its judgement.
[[nodiscard]] AttemptRules recordedRules(AttemptRules exercise, const TrialHeader& header);

}  // namespace torsio
