// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/angle.h"

namespace torsio {

/// Largest turn of the gimbal's third joint to either side of neutral (published for the Omni and Touch).
inline constexpr double kRollRange_rad = radians(150.0);
/// Angle from its stop within which the joint counts as being at the stop: noise of a potentiometer and
/// calibration.
inline constexpr double kRollStopMargin_rad = radians(2.0);

/// Turn of the stylus about its own axis from gimbal angle 3: unwrapped, right-handed about the stylus's z
/// axis (hence minus the clockwise gimbal angle), counted from the docked reference once there is one. Servo
/// thread; a plain value.
class StylusRoll {
 public:
  /// Takes the joint's angle (the Touch's convention, wrapped to +-pi).
  void follow(double gimbalRoll_rad) noexcept {
    const double turn_rad = -gimbalRoll_rad;
    unwrapped_rad_ = started_ ? unwrapNear(turn_rad, unwrapped_rad_) : turn_rad;
    started_ = true;
  }
  /// Returns the turn of the stylus, rad; without a reference it counts from the joint's neutral position.
  [[nodiscard]] double turn_rad() const noexcept { return unwrapped_rad_ - reference_rad_; }
  /// Makes the present angle zero, because the stylus rests in the inkwell.
  void reference() noexcept {
    reference_rad_ = unwrapped_rad_;
    referenced_ = true;
  }

  [[nodiscard]] bool referenced() const noexcept { return referenced_; }
  /// Tells whether the joint is at its mechanical stop: the turn must go on after a new grip.
  [[nodiscard]] bool atStop() const noexcept {
    const double free_rad = kRollRange_rad - kRollStopMargin_rad;
    return unwrapped_rad_ > free_rad || unwrapped_rad_ < -free_rad;
  }

 private:
  double unwrapped_rad_ = 0.0;
  double reference_rad_ = 0.0;
  bool started_ = false;
  bool referenced_ = false;
};

}  // namespace torsio
