// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/twist_count.h"

#include <algorithm>
#include <cmath>

#include "assessment/attempt/recorded_twists.h"
#include "sim/core/device_sample.h"

namespace torsio {

void TwistCount::see(const LiveState& state) noexcept {
  if (state.times.released_us > released_us_) {
    const bool byHand = (state.deviceStatus & (kDeviceLost | kDeviceUncalibrated | kDeviceEnded)) == 0;
    if (byHand && largest_rad_ >= kSmallestTwist_rad) {
      ++completed_;
      releasedAt_rad_ = latest_rad_;
    }
    released_us_ = state.times.released_us;
    largest_rad_ = 0.0;
  }
  if (state.phase == ExercisePhase::kTwisting) {
    latest_rad_ = state.response.angle_rad;
    largest_rad_ = std::max(largest_rad_, std::abs(state.response.angle_rad));
  }
}

}  // namespace torsio
