// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Records one twist to `target_rad` by a scripted hand that has nothing left to learn (RecordedRun); the
/// same every time. Takes a fraction of a second. Throws Error{kBadParameter} when the hand cannot reach the
/// organ.
[[nodiscard]] Trial expertRun(const Scene& scene, double target_rad);

/// Label of stored expert runs (TrialHeader::phaseLabel).
inline constexpr const char* kExpertPhase = "example by an instructor";

}  // namespace torsio
