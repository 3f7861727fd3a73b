// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/steering/rate_steering.h"

#include <algorithm>
#include <cmath>

namespace torsio {

namespace {

/// The user's right is the patient's left (x), up is towards the head (z), towards the user is towards the
/// patient's front (-y): a quarter turn about x.
constexpr Quat kUserToWorld{0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1, 0.0, 0.0};

bool isFinite(const SteeringInput& input) noexcept {
  return isFinite(input.move) && std::isfinite(input.yaw) && std::isfinite(input.pitch) &&
         std::isfinite(input.roll) && std::isfinite(input.grip);
}

double unit(double value) noexcept {
  return std::clamp(value, -1.0, 1.0);
}

}  // namespace

double steeringCurve(double deflection, double dead) noexcept {
  const double size = std::min(std::abs(deflection), 1.0);
  if (!(size > dead)) {
    return 0.0;
  }
  const double share = (size - dead) / (1.0 - dead);
  return std::copysign(share * share, deflection);
}

RateSteering::RateSteering(const Vec3& start_m, const Vec3& centre_m) noexcept
    : centre_m_(centre_m), position_m_(start_m) {}

void RateSteering::step(const SteeringInput& input, double step_s) noexcept {
  invalid_ = !isFinite(input);
  if (invalid_) {
    return;
  }
  const double time_s = std::clamp(step_s, 0.0, kSteeringStepMost_s);
  const double share = time_s / (kSteeringSmoothing_s + time_s);
  move_ += (Vec3{unit(input.move.x), unit(input.move.y), unit(input.move.z)} - move_) * share;
  yaw_ += (unit(input.yaw) - yaw_) * share;
  pitch_ += (unit(input.pitch) - pitch_) * share;
  roll_ += (unit(input.roll) - roll_) * share;
  grip_ += (std::clamp(input.grip, 0.0, 1.0) - grip_) * share;
  buttons_ = input.buttons;

  const Vec3 goal_m = position_m_ + rotate(kUserToWorld, move_) * (kSteeringSpeed_m_per_s * time_s);
  const auto within = [](double value_m, double middle_m) {
    return std::clamp(value_m, middle_m - kSteeringReach_m, middle_m + kSteeringReach_m);
  };
  position_m_ = {within(goal_m.x, centre_m_.x), within(goal_m.y, centre_m_.y), within(goal_m.z, centre_m_.z)};
  const auto tilted = [time_s](double angle_rad, double rate) {
    return std::clamp(angle_rad + rate * kSteeringTilt_rad_per_s * time_s, -kSteeringTiltMost_rad,
                      kSteeringTiltMost_rad);
  };
  yaw_rad_ = tilted(yaw_rad_, yaw_);
  pitch_rad_ = tilted(pitch_rad_, pitch_);
  roll_rad_ += roll_ * kSteeringRoll_rad_per_s * time_s;
}

DeviceReading RateSteering::reading(std::int64_t time_us) const noexcept {
  DeviceReading reading;
  reading.time_us = time_us;
  reading.pose.position_m = position_m_;
  reading.pose.orientation = kUserToWorld * axisAngle({0.0, 1.0, 0.0}, yaw_rad_) *
                             axisAngle({1.0, 0.0, 0.0}, pitch_rad_) * axisAngle({0.0, 0.0, 1.0}, roll_rad_);
  reading.roll_rad = roll_rad_;
  reading.grip = grip_;
  reading.buttons = buttons_ | (grip_ > 0.5 ? static_cast<std::uint32_t>(kButtonGrip) : 0U);
  reading.status = invalid_ ? kDeviceInvalid : kDeviceOk;
  return reading;
}

}  // namespace torsio
