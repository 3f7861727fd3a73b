// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/virtual/pointer_device.h"

#include <algorithm>
#include <cmath>

namespace torsio {

namespace {

bool isFinite(const Quat& q) noexcept {
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

bool isFinite(const PointerInput& input) noexcept {
  return isFinite(input.onPlane_m) && isFinite(input.view) && std::isfinite(input.depth_m) &&
         std::isfinite(input.yaw_rad) && std::isfinite(input.pitch_rad) && std::isfinite(input.roll_rad) &&
         std::isfinite(input.grip);
}

}  // namespace

PointerDevice::PointerDevice(const Pose& start) : view_(normalized(start.orientation)) {
  capabilities_.model = "Mouse and keyboard";
  capabilities_.drive = TwistDrive::kRoll;  // a mouse cannot be led round an organ: it turns
  target_.position_m = start.position_m;
  halfway_ = target_;
  steering_ = target_;
}

void PointerDevice::follow(const Steering& target, double step_s) noexcept {
  const double share = 1.0 - portableExp(-step_s / kPointerSmoothing_s);
  const auto approach = [share](Steering& value, const Steering& goal) {
    value.position_m += (goal.position_m - value.position_m) * share;
    value.yaw_rad += (goal.yaw_rad - value.yaw_rad) * share;
    value.pitch_rad += (goal.pitch_rad - value.pitch_rad) * share;
    value.roll_rad += (goal.roll_rad - value.roll_rad) * share;
    value.grip += (goal.grip - value.grip) * share;
  };
  approach(halfway_, target);
  const Vec3 before_m = steering_.position_m;
  approach(steering_, halfway_);
  const Vec3 step_m = steering_.position_m - before_m;
  const double longest_m = kPointerSpeedLimit_m_per_s * step_s;
  const double length_m = norm(step_m);
  if (length_m > longest_m) {
    steering_.position_m = before_m + step_m * (longest_m / length_m);
  }
}

DeviceSample PointerDevice::read(std::int64_t time_us) noexcept {
  const PointerInput input = inputs_.latest();
  DeviceReading reading;
  reading.time_us = time_us;
  if (!isFinite(input)) {
    reading.status = kDeviceInvalid;
  } else if (input.present) {
    const Quat view = normalized(input.view);
    // Going round the organ with the camera must not turn what the jaw holds.
    if (target_.grip <= 0.5) {
      view_ = view;
    }
    target_.position_m = input.onPlane_m + rotate(view, {0.0, 0.0, -input.depth_m});
    target_.yaw_rad = input.yaw_rad;
    target_.pitch_rad = input.pitch_rad;
    target_.roll_rad = input.roll_rad;
    target_.grip = kPointerClosure * std::clamp(input.grip, 0.0, 1.0);
    reading.buttons = input.buttons;
  } else {
    target_.grip = 0.0;
  }
  if (started_) {
    follow(target_, static_cast<double>(std::max<std::int64_t>(0, time_us - last_us_)) * 1e-6);
  }
  started_ = true;
  last_us_ = time_us;

  reading.pose.position_m = steering_.position_m;
  reading.pose.orientation = view_ * axisAngle({0.0, 1.0, 0.0}, steering_.yaw_rad) *
                             axisAngle({1.0, 0.0, 0.0}, steering_.pitch_rad) *
                             axisAngle({0.0, 0.0, 1.0}, steering_.roll_rad);
  reading.roll_rad = steering_.roll_rad;
  reading.grip = steering_.grip;
  sample_ = quantize(reading, sample_);
  return sample_;
}

}  // namespace torsio
