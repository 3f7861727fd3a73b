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

/// Follows the clip and the way out for the content through a recording, sample by sample, as the servo
/// decides them: by command, the clip also by the second button, each time that it is pressed by an
/// instrument that touched or held the organ in the tick before. A plain value; any one thread.
class RecordedSwitches {
 public:
  /// Takes the next sample.
  void obey(const Sample& sample) noexcept;
  /// Whether a clip or an assistant holds the organ in this tick.
  [[nodiscard]] bool clipped() const noexcept { return clipped_; }
  /// Whether the way out has been opened; whether anything leaves by it is the scene's to say.
  [[nodiscard]] bool venting() const noexcept { return venting_; }

 private:
  bool clipped_ = false;
  bool venting_ = false;
  bool pressed_ = true;   // one that is held down at the start sets no clip
  bool atOrgan_ = false;  // in the tick before
};

/// Whether a recording is that of an organ which came twisted and is to be undone.
[[nodiscard]] bool comesTwisted(std::span<const Sample> samples) noexcept;

/// Measures the untwisting of a recording that comesTwisted. `times_us` (sampleTimes) has one entry a sample;
/// without `peakShear_Pa` the stress of the wall stays undefined. Undefined as a whole with fewer than two
/// samples, a gap of more than 20 ms, or no rules.
[[nodiscard]] Outcome<DetorsionMetrics> measureRecordedDetorsion(
    std::span<const Sample> samples, std::span<const std::int64_t> times_us,
    const std::optional<DetorsionRules>& rules,
    const std::function<double(const Sample& sample)>& peakShear_Pa = {});

}  // namespace torsio
