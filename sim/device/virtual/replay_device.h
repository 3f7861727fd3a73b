// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "sim/device/haptic_device.h"

namespace torsio {

/// Gives recorded samples again, one a read, whatever the time asked for.
///
/// | channel     | direction | unit            | value                                        |
/// |-------------|-----------|-----------------|----------------------------------------------|
/// | position    | given     | kPositionStep_m | as recorded                                  |
/// | orientation | given     | kOrientationStep| as recorded                                  |
/// | roll        | given     | kRollStep_rad   | as recorded                                  |
/// | grip        | given     | kGripStep       | as recorded                                  |
/// | buttons     | given     |                 | as recorded                                  |
/// | status      | given     |                 | as recorded; kDeviceEnded after the last one |
/// | force       | taken     | N               | ignored                                      |
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

}  // namespace torsio
