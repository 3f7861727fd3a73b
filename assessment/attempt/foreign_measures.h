// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/base/live_types.h"
#include "sim/record/trial.h"

namespace torsio {

/// Fewest samples a second of which a path can be filtered at kPoseCutoff_Hz.
inline constexpr double kSlowestForeign_Hz = 20.0;

/// Measures what other equipment recorded (isForeign): time, path and rest of the tip, the places between two
/// samples on a straight line. Every other metric is undefined, never 0: "not applicable: foreign recording".
/// Undefined as a whole with fewer than two samples, fewer than kSlowestForeign_Hz, or a gap of more than
/// 20 ms and two and a half samples. Any thread.
[[nodiscard]] Outcome<TrialMetrics> measureForeign(const TrialHeader& header,
                                                   std::span<const Sample> samples);

/// Measures such a recording for keeping: metrics that are defined, the time in any case, and no twist.
[[nodiscard]] AttemptMeasures foreignAttempt(const TrialHeader& header, std::span<const Sample> samples);

}  // namespace torsio
