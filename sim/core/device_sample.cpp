// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/device_sample.h"

#include <cmath>
#include <limits>

namespace torsio {

namespace {

/// Rounds half away from zero; false when the value does not fit.
bool toSteps(double value, double step, std::int32_t& out) noexcept {
  const double steps = value / step;
  constexpr double kLimit = static_cast<double>(std::numeric_limits<std::int32_t>::max());
  if (!(std::abs(steps) < kLimit)) {
    return false;  // also catches NaN
  }
  out = static_cast<std::int32_t>(steps < 0.0 ? steps - 0.5 : steps + 0.5);
  return true;
}

}  // namespace

DeviceSample quantize(const DeviceReading& reading, const DeviceSample& previous) noexcept {
  DeviceSample sample = previous;
  const Quat q = normalized(reading.pose.orientation);
  std::array<std::int32_t, 3> position{};
  std::array<std::int32_t, 4> orientation{};
  std::int32_t roll = 0;
  std::int32_t grip = 0;
  const Vec3& p = reading.pose.position_m;
  const double length = norm(reading.pose.orientation);  // NaN and zero quaternions fail here
  const bool good =
      std::isfinite(length) && length > 0.0 && toSteps(p.x, kPositionStep_m, position[0]) &&
      toSteps(p.y, kPositionStep_m, position[1]) && toSteps(p.z, kPositionStep_m, position[2]) &&
      toSteps(q.w, kOrientationStep, orientation[0]) && toSteps(q.x, kOrientationStep, orientation[1]) &&
      toSteps(q.y, kOrientationStep, orientation[2]) && toSteps(q.z, kOrientationStep, orientation[3]) &&
      toSteps(reading.roll_rad, kRollStep_rad, roll) && toSteps(reading.grip, kGripStep, grip);
  sample.time_us = reading.time_us;
  sample.buttons = reading.buttons;
  sample.status = reading.status;
  if (!good) {
    sample.status |= kDeviceInvalid;
    return sample;
  }
  sample.position = position;
  sample.orientation = orientation;
  sample.roll = roll;
  sample.grip = grip;
  return sample;
}

ToolState toolState(const DeviceSample& sample) noexcept {
  const auto metres = [](std::int32_t steps) { return static_cast<double>(steps) * kPositionStep_m; };
  const auto unit = [](std::int32_t steps) { return static_cast<double>(steps) * kOrientationStep; };
  ToolState tool;
  tool.time_us = sample.time_us;
  tool.pose.position_m = {metres(sample.position[0]), metres(sample.position[1]), metres(sample.position[2])};
  tool.pose.orientation = normalized(Quat{unit(sample.orientation[0]), unit(sample.orientation[1]),
                                          unit(sample.orientation[2]), unit(sample.orientation[3])});
  tool.roll_rad = static_cast<double>(sample.roll) * kRollStep_rad;
  tool.grip = static_cast<double>(sample.grip) * kGripStep;
  tool.buttons = sample.buttons;
  tool.status = sample.status;
  return tool;
}

}  // namespace torsio
