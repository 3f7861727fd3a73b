// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "sim/device/device_driver.h"
#include "sim/device/haptic_device.h"

namespace torsio {

/// Plays recorded samples back, one per read, whatever the time asked for; kDeviceEnded after the last one.
/// Ignores forces.
class ReplayDevice final : public HapticDevice {
 public:
  /// Makes a device that gives `samples`, with the `capabilities` of the device that was recorded.
  ReplayDevice(std::vector<DeviceSample> samples, DeviceCapabilities capabilities);

  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand&) noexcept override {}

 private:
  std::vector<DeviceSample> samples_;
  DeviceCapabilities capabilities_;
  std::size_t next_ = 0;
};

/// A device that nobody holds: the instrument stays where it was put, its jaw open. For pictures, views and
/// tests.
class IdleDevice final : public HapticDevice {
 public:
  explicit IdleDevice(const Pose& pose);

  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand&) noexcept override {}

 private:
  DeviceCapabilities capabilities_;
  DeviceSample sample_;
};

/// Mouse and keyboard.
[[nodiscard]] DeviceDriver pointerDriver();
/// A simulated hand, which comes from `start` and grasps at the centre of the workspace.
[[nodiscard]] DeviceDriver scriptedHandDriver();
/// What was recorded, tick by tick.
[[nodiscard]] DeviceDriver replayDriver();
/// Driver of IdleDevice: the instrument stays at `start`.
[[nodiscard]] DeviceDriver idleDriver();

}  // namespace torsio
