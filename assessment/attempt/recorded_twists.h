// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/angle.h"
#include "sim/core/live_types.h"
#include "sim/record/trial.h"

namespace torsio {

inline constexpr double kMicrosecondsPerSecond = 1e6;

/// A grip that at no moment turned the organ by this much was a touch, not a twist. The largest angle of the
/// grip decides, not the one at letting go: who turns back to zero has twisted, and missed.
inline constexpr double kSmallestTwist_rad = radians(2.0);
/// The angle has been held when it stayed on target for at least this long until it was let go.
inline constexpr double kShortestHold_s = 0.2;

/// How a twist came to its end. Only one that was let go is completed: it alone is judged. The others are
/// counted apart, everywhere.
enum class TwistEnding : std::uint8_t {
  kLetGo,           ///< the jaw opened or slipped off, or somebody pressed "let go"
  kRecordingEnded,  ///< the recording stops while the organ is held
  kDeviceFault,     ///< the device was lost or not calibrated: the program let go, not the hand
  kNotSeen,         ///< samples are missing for more than 20 ms where it was let go
};

/// One twist of a recording: from the grip to the end of the elastic return.
struct RecordedTwist {
  std::size_t first = 0;        ///< first sample of the grip
  std::size_t letGo = 0;        ///< sample after the last one of the grip
  std::size_t end = 0;          ///< sample after the last one of the return
  double target_rad = 0.0;      ///< in force at the last sample of the grip
  double releasedAt_rad = 0.0;  ///< angle at the last sample of the grip
  TwistEnding ending = TwistEnding::kLetGo;

  /// Whether the twist counts as one: it was let go, and that was recorded.
  [[nodiscard]] bool completed() const noexcept { return ending == TwistEnding::kLetGo; }
  /// Distance between the angle at letting go and the target, at least 0, rad.
  [[nodiscard]] double error_rad() const noexcept;
  /// Whether the twist was let go within `tolerance_rad` of the target in force. A twist that is not
  /// completed never is.
  [[nodiscard]] bool onTarget(double tolerance_rad) const noexcept;
};

/// When the samples of a recording were taken.
struct SampleTimes {
  bool deviceClock = true;  ///< false: ticks times the tick period, because the device's stamps do not rise
  std::vector<std::int64_t> us{};  ///< one entry a sample, strictly rising
};

/// Reads the time stamps of `samples`: those of the device where they rise, else the ticks.
[[nodiscard]] SampleTimes sampleTimes(const TrialHeader& header, std::span<const Sample> samples);

/// Returns how long `samples` lasted, in microseconds: from the first stamp to one tick after the last; 0
/// without samples.
[[nodiscard]] std::int64_t recordedDuration_us(const TrialHeader& header, std::span<const Sample> samples);

/// Returns the target angle in force at every sample: the header's until a command changes it.
[[nodiscard]] std::vector<double> targetsInForce(const TrialHeader& header, std::span<const Sample> samples);

/// Finds the twists of a recording in their order, touches left out, those that were not completed included.
/// `times_us` (sampleTimes) and `targets_rad` (targetsInForce) have one entry a sample each. This is the one
/// definition of a twist that reports, debriefs, trends, mastery, metrics and exports share.
[[nodiscard]] std::vector<RecordedTwist> recordedTwists(std::span<const Sample> samples,
                                                        std::span<const std::int64_t> times_us,
                                                        std::span<const double> targets_rad);

/// Returns the first sample of the stay on target that lasted until letting go; `twist.letGo` when there was
/// none.
[[nodiscard]] std::size_t onTargetSince(const RecordedTwist& twist, std::span<const Sample> samples,
                                        double tolerance_rad);

}  // namespace torsio
