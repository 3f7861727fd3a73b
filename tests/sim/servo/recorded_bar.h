// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/domain/ids.h"
#include "sim/record/trial.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {

/// The straight bar of the recordings in tests/data: its outline has the same bits on every machine.
[[nodiscard]] const Scene& recordedBar();

/// Runs a scripted hand for eight seconds on recordedBar(), and returns what the servo loop answered as a
/// finished trial. `tests/data/trials` was made by it.
[[nodiscard]] Trial recordOnBar(const TrialId& trialId, const std::string& traineeCode, TwistDrive drive);

}  // namespace torsio
