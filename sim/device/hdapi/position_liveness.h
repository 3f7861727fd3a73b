// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "sim/device/hdapi/hdapi_border.h"

namespace torsio {

/// Way that the position's noise and the smallest step of its encoders (0.055 mm) always exceed in a hand.
inline constexpr double kPositionNoise_mm = 0.02;
/// Turn of the gimbal during which a held stylus cannot keep its position within kPositionNoise_mm.
inline constexpr double kGimbalMoves_rad = 0.1;

/// Tells a position that no longer follows the hand from one that rests: the gimbal turns and the position
/// stays. In the inkwell a stylus may be turned on the spot. Servo thread; a plain value.
class PositionLiveness {
 public:
  /// Takes one frame (valid numbers) and tells whether the position is frozen.
  [[nodiscard]] bool frozen(const HdapiFrame& frame, bool docked) noexcept {
    double way_mm = 0.0;
    double turn_rad = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      way_mm = std::max(way_mm, std::abs(frame.transform_mm[12 + i] - anchor_mm_[i]));
      turn_rad = std::max(turn_rad, std::abs(frame.gimbal_rad[i] - anchor_rad_[i]));
    }
    if (!started_ || docked || way_mm > kPositionNoise_mm) {
      started_ = true;
      for (std::size_t i = 0; i < 3; ++i) {
        anchor_mm_[i] = frame.transform_mm[12 + i];
      }
      anchor_rad_ = frame.gimbal_rad;
      frozen_ = false;
    } else if (turn_rad > kGimbalMoves_rad) {
      frozen_ = true;
    }
    return frozen_;
  }

 private:
  std::array<double, 3> anchor_mm_{};
  std::array<double, 3> anchor_rad_{};
  bool started_ = false;
  bool frozen_ = false;
};

}  // namespace torsio
