// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "assessment/metrics/detorsion.h"
#include "assessment/statistics/values.h"
#include "sim/core/live_types.h"

namespace torsio {

/// Reconstructs clip and vent sample by sample, with the servo's logic: by command, and the clip also by the
/// second button whenever it is pressed while the instrument touched or held the organ in the previous tick.
/// A plain value; any one thread.
class RecordedSwitches {
 public:
  /// Processes the next sample.
  void obey(const Sample& sample) noexcept;
  /// Returns whether a clip or an assistant holds the organ in this tick.
  [[nodiscard]] bool clipped() const noexcept { return clipped_; }
  /// Returns whether the vent is open; the scene determines whether anything escapes.
  [[nodiscard]] bool venting() const noexcept { return venting_; }

 private:
  bool clipped_ = false;
  bool venting_ = false;
  bool pressed_ = true;   // a button held down at the start sets no clip
  bool atOrgan_ = false;  // in the previous tick
};

/// Returns whether the recording is of an organ that starts twisted and is to be untwisted.
[[nodiscard]] bool comesTwisted(std::span<const Sample> samples) noexcept;

/// Measures the untwisting of a recording with comesTwisted(). `times_us` (sampleTimes) has one entry per
/// sample; without `peakShear_Pa`, wall stress is undefined. Undefined as a whole with fewer than two
/// samples, a gap of more than 20 ms, or without rules.
[[nodiscard]] Outcome<DetorsionMetrics> measureRecordedDetorsion(
    std::span<const Sample> samples, std::span<const std::int64_t> times_us,
    const std::optional<DetorsionRules>& rules,
    const std::function<double(const Sample& sample)>& peakShear_Pa = {});

}  // namespace torsio
