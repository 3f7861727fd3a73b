// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/core/live_types.h"
#include "sim/record/trial.h"

namespace torsio {

/// Fewest samples a second of which a path can be filtered at kPoseCutoff_Hz.
inline constexpr double kSlowestForeign_Hz = 20.0;

/// Least share of the time between first and last sample that must be seen without gaps.
inline constexpr double kLeastSeen = 0.95;

/// Measures what other equipment recorded (isForeign): time, path and rest of the tip, the places between two
/// samples on a straight line. Every other metric is undefined, never 0: "not applicable: foreign recording".
/// A gap is longer than 20 ms and two and a half samples: path and rest are those of the stretches between
/// gaps, and nothing is made up within one. Samples whose numbers were left out (Sample::tick) count as lost.
/// Undefined as a whole with fewer than two samples, fewer than kSlowestForeign_Hz, or less than kLeastSeen.
/// Any thread.
[[nodiscard]] Outcome<TrialMetrics> measureForeign(const TrialHeader& header,
                                                   std::span<const Sample> samples);

/// Measures such a recording for keeping: metrics that are defined, the time in any case, and no twist.
[[nodiscard]] AttemptMeasures foreignAttempt(const TrialHeader& header, std::span<const Sample> samples);

}  // namespace torsio
