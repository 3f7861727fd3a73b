// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/live_types.h"

namespace torsio {

/// Counts the twists of a run in progress like recordedTwists(), from snapshots of its ticks. A plain value,
/// one thread.
class TwistCount {
 public:
  /// Processes the next snapshot; ticks in between may be skipped.
  void see(const LiveState& state) noexcept;
  /// Returns the number of completed twists so far.
  [[nodiscard]] std::int64_t completed() const noexcept { return completed_; }
  /// Returns the angle at which the latest one was released, rad; 0 before the first.
  [[nodiscard]] double releasedAt_rad() const noexcept { return releasedAt_rad_; }

 private:
  std::int64_t completed_ = 0;
  std::int64_t released_us_ = -1;
  double largest_rad_ = 0.0;  // of the current grip
  double latest_rad_ = 0.0;   // of the current grip
  double releasedAt_rad_ = 0.0;
};

}  // namespace torsio
