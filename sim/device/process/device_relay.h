// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "sim/device/hosted_device.h"
#include "sim/device/process/device_channel.h"

namespace torsio {

/// The device process's tick: between a driver's reading and its force, the one goes into the shared memory
/// and the other comes from there. The driver's thread; no allocation, no lock.
struct DeviceRelay {
  DeviceChannel* channel = nullptr;
  HapticDevice* device = nullptr;
  std::uint64_t seenForce = 0;
  std::uint32_t seenDrops = 0;

  void tick(std::int64_t time_us) noexcept {
    const std::uint64_t number = channel->frames.load(std::memory_order_relaxed) + 1;
    channel->reading.publish({device->read(time_us), number});
    channel->frames.store(number, std::memory_order_release);
    device->enableForce(channel->forceWished.load(std::memory_order_relaxed));
    const std::uint32_t drops = channel->drops.load(std::memory_order_relaxed);
    if (drops != seenDrops) {
      seenDrops = drops;
      device->dropForce();
    }
    const std::optional<MailedForce> force = channel->force.latest();
    if (force && force->number != seenForce) {  // one that is not renewed expires in the driver
      seenForce = force->number;
      device->write({force->force_N, 0});
    }
  }
  /// As the driver calls it.
  [[nodiscard]] DeviceTick asTick() noexcept {
    return {[](void* context, std::int64_t time_us) { static_cast<DeviceRelay*>(context)->tick(time_us); },
            this};
  }
};

}  // namespace torsio
