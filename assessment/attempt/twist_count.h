// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/live_types.h"

namespace torsio {

/// Counts the twists of a run while it goes on, as recordedTwists does afterwards, from snapshots of its
/// ticks. A plain value, one thread.
class TwistCount {
 public:
  /// Takes the next snapshot; some ticks may have passed unseen in between.
  void see(const LiveState& state) noexcept;
  /// Returns how many twists were completed so far.
  [[nodiscard]] std::int64_t completed() const noexcept { return completed_; }
  /// Returns the angle at which the latest of them was let go, rad; 0 before the first.
  [[nodiscard]] double releasedAt_rad() const noexcept { return releasedAt_rad_; }

 private:
  std::int64_t completed_ = 0;
  std::int64_t released_us_ = -1;
  double largest_rad_ = 0.0;  // of the present grip
  double latest_rad_ = 0.0;   // of the present grip
  double releasedAt_rad_ = 0.0;
};

}  // namespace torsio
