// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "assessment/report/cohort_report.h"
#include "sim/base/live_types.h"
#include "sim/record/trial.h"

namespace torsio {

/// What the report says of one recorded trial: twists counted from grip to release, each judged by the angle
/// at which it was let go against the trial's target. `samples` are the decoded samples of `trial`. The
/// caller fills in group and model.
[[nodiscard]] TrialDigest trialDigest(const Trial& trial, std::span<const Sample> samples,
                                      double tolerance_rad);

}  // namespace torsio
