// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/haptic_device.h"

namespace torsio {

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

}  // namespace torsio
