// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/virtual/replay_device.h"

#include <utility>

namespace torsio {

ReplayDevice::ReplayDevice(std::vector<DeviceSample> samples, DeviceCapabilities capabilities)
    : samples_(std::move(samples)), capabilities_(std::move(capabilities)) {
  capabilities_.realTime = false;
}

DeviceSample ReplayDevice::read(std::int64_t time_us) noexcept {
  if (next_ < samples_.size()) {
    return samples_[next_++];
  }
  DeviceSample last = samples_.empty() ? DeviceSample{} : samples_.back();
  last.time_us = time_us;
  last.status |= kDeviceEnded;
  return last;
}

}  // namespace torsio
