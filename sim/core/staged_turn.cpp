// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/staged_turn.h"

#include <algorithm>
#include <cmath>

namespace torsio {

void StagedTurn::take(double time_s, double angle_rad) noexcept {
  size_rad_ = std::abs(angle_rad);
  if (!begun_) {
    from_rad_ = size_rad_;
  }
  if (!begun_ || std::abs(size_rad_ - around_rad_) > kRestingSway_rad) {
    around_rad_ = size_rad_;
    since_s_ = time_s;
  }
  begun_ = true;
  still_s_ = (time_s - since_s_) * timeScale_;
  from_rad_ = still_s_ >= stages_.rest_s ? size_rad_ : std::max(from_rad_, size_rad_);
  longest_rad_ = std::max(longest_rad_, stage_rad());
}

}  // namespace torsio
