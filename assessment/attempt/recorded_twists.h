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

/// A grip that never turned the organ by this much is a touch, not a twist. The maximum angle of the grip
/// counts, not the one at release: turning back to zero is a twist that missed.
inline constexpr double kSmallestTwist_rad = radians(2.0);
/// Minimum time on target before the release for a hold.
inline constexpr double kShortestHold_s = 0.2;

/// How a twist ended. Only a released twist is completed and judged; the others are counted separately
/// everywhere.
enum class TwistEnding : std::uint8_t {
  kLetGo,           ///< the jaw opened or slipped off, or the user pressed "let go"
  kRecordingEnded,  ///< the recording ends while the organ is held
  kDeviceFault,     ///< the device was lost or not calibrated: released by the program, not the hand
  kNotSeen,         ///< samples are missing for more than 20 ms at the release
};

/// A twist of a recording, from the grip to the end of the elastic return.
struct RecordedTwist {
  std::size_t first = 0;        ///< first sample of the grip
  std::size_t letGo = 0;        ///< sample after the last one of the grip
  std::size_t end = 0;          ///< sample after the last one of the return
  double target_rad = 0.0;      ///< at the last sample of the grip
  double releasedAt_rad = 0.0;  ///< angle at the last sample of the grip
  TwistEnding ending = TwistEnding::kLetGo;

  /// Returns whether the twist was released and the release was recorded.
  [[nodiscard]] bool completed() const noexcept { return ending == TwistEnding::kLetGo; }
  /// Returns the absolute difference between the angle at release and the target, rad.
  [[nodiscard]] double error_rad() const noexcept;
  /// Returns whether the twist was released within `tolerance_rad` of its target; false if it is not
  /// completed.
  [[nodiscard]] bool onTarget(double tolerance_rad) const noexcept;
};

/// Times of a recording's samples.
struct SampleTimes {
  bool deviceClock = true;  ///< false: ticks times the tick period, because the device's time stamps do not
                            ///< increase
  std::vector<std::int64_t> us{};  ///< one per sample, strictly increasing
};

/// Returns the times of `samples`: the device's time stamps if they increase, else the ticks.
[[nodiscard]] SampleTimes sampleTimes(const TrialHeader& header, std::span<const Sample> samples);

/// Returns the duration of `samples`, us: from the first time to one tick after the last; 0 without samples.
[[nodiscard]] std::int64_t recordedDuration_us(const TrialHeader& header, std::span<const Sample> samples);

/// Returns the target angle at every sample: the header's, until a command changes it.
[[nodiscard]] std::vector<double> targetsInForce(const TrialHeader& header, std::span<const Sample> samples);

/// Finds the twists of a recording in order, including those not completed, excluding touches. `times_us`
/// (sampleTimes) and `targets_rad` (targetsInForce) have one entry per sample. The only definition of a
/// twist, shared by reports, debriefs, trends, mastery, metrics and exports.
[[nodiscard]] std::vector<RecordedTwist> recordedTwists(std::span<const Sample> samples,
                                                        std::span<const std::int64_t> times_us,
                                                        std::span<const double> targets_rad);

/// Returns the first sample of the time on target that lasted until the release; `twist.letGo` if there was
/// none.
[[nodiscard]] std::size_t onTargetSince(const RecordedTwist& twist, std::span<const Sample> samples,
                                        double tolerance_rad);

}  // namespace torsio
