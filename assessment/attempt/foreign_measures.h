// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/core/live_types.h"
#include "sim/core/text.h"
#include "sim/record/trial.h"

namespace torsio {

/// Minimum sample rate for filtering a path at kPoseCutoff_Hz.
inline constexpr double kSlowestForeign_Hz = 20.0;

/// Minimum share of the time between first and last sample without gaps.
inline constexpr double kLeastSeen = 0.95;

/// Measures a recording of other equipment (isForeign()): time, path and idle time of the tip, with positions
/// interpolated linearly. All other metrics are undefined, never 0: "not applicable: foreign recording". A
/// gap is longer than both 20 ms and two and a half samples; path and idle time are those outside gaps,
/// nothing is interpolated within one. A pose that stays the same bit for bit for more than kFrozenPose_us is
/// a gap too: a tracker that has lost the instrument repeats its last pose. Missing ticks (Sample::tick)
/// count as lost. Undefined as a whole with fewer than two samples, a rate below kSlowestForeign_Hz, or a
/// share below kLeastSeen. Any thread.
[[nodiscard]] Outcome<TrialMetrics> measureForeign(const TrialHeader& header,
                                                   std::span<const Sample> samples);

/// A stretch of a recording, in microseconds since its first sample.
struct Unseen {
  std::int64_t from_us = 0;
  std::int64_t to_us = 0;
};
/// Returns the gaps of such a recording, as measureForeign() knows them, in order. Any thread.
[[nodiscard]] std::vector<Unseen> unseenStretches(const TrialHeader& header, std::span<const Sample> samples);

/// Returns the measures to store for such a recording: defined metrics, always the time and, with two
/// samples, how often and how long the instrument was out of view; no twists.
[[nodiscard]] AttemptMeasures foreignAttempt(const TrialHeader& header, std::span<const Sample> samples);

/// Says what such a recording measured, a sentence each: path and idle time if they are defined, then how
/// often and how long the instrument was out of view and what follows from it. `values`:
/// AttemptMeasures::values.
[[nodiscard]] std::vector<Text> foreignSentences(const QuantityValues& values);

}  // namespace torsio
