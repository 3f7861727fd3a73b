// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/virtual/idle_device.h"

namespace torsio {

IdleDevice::IdleDevice(const Pose& pose) {
  capabilities_.model = "Idle";
  capabilities_.realTime = false;
  DeviceReading reading;
  reading.pose = pose;
  sample_ = quantize(reading, sample_);
}

DeviceSample IdleDevice::read(std::int64_t time_us) noexcept {
  sample_.time_us = time_us;
  return sample_;
}

}  // namespace torsio
