// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/services/training/detorsion_story.h"
#include "assessment/attempt/measured_trial.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/catalogue/quantity.h"
#include "sim/core/text.h"

namespace torsio {

/// A time range of the recording, since the first sample.
struct Seconds {
  double from_s = 0.0;
  double to_s = 0.0;
  friend bool operator==(const Seconds&, const Seconds&) = default;
};

/// The samples of a recording with their times. Keeps a view of the samples.
struct Timeline {
  std::span<const Sample> samples;
  std::vector<std::int64_t> times_us;

  Timeline(const TrialHeader& header, std::span<const Sample> all);
  /// Returns the time of a sample since the first one.
  [[nodiscard]] double at_s(std::size_t sample) const;
};

/// Returns the part of a twist that shows a quantity's `value`.
[[nodiscard]] Seconds momentInTwist(Quantity quantity, double value, const Timeline& line,
                                    const MeasuredTrial& run, const MeasuredTwist& twist);

/// Where a requirement was missed, and what to try next.
struct MissedTarget {
  std::optional<Seconds> when{};  ///< empty: nothing in the recording shows it
  Text advice{};                  ///< empty: given with an earlier check
};

/// Finds for each check of the verdict where it was missed; empty for one that was met or not measured
/// because samples were lost.
[[nodiscard]] std::vector<std::optional<MissedTarget>> missedTargets(const RunVerdict& verdict,
                                                                     const Timeline& line,
                                                                     const MeasuredTrial& run);
/// Like the overload above, for an untwisting: at an event or an extreme of its story.
[[nodiscard]] std::vector<std::optional<MissedTarget>> missedTargets(const RunVerdict& verdict,
                                                                     const Timeline& line,
                                                                     const DetorsionStory& story);

}  // namespace torsio
