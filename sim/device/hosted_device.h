// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/device_sample.h"
#include "sim/core/vec3.h"
#include "sim/device/haptic_device.h"

namespace torsio {

/// Called once a tick in the driver's own thread, between a reading and the force that answers it. noexcept
/// by contract; no allocation, no lock.
struct DeviceTick {
  void (*run)(void* context, std::int64_t time_us) = nullptr;
  void* context = nullptr;
};

/// A device whose driver can run in the device process (sim/device/process): its thread calls a tick, and it
/// can be let go of while that thread hangs.
class HostedDevice : public HapticDevice {
 public:
  /// Starts the driver's thread, driven by `tick` or, without one, over mailboxes. Once. Throws
  /// Error{kDevice}.
  virtual void start(const DeviceTick& tick) = 0;
  /// Begins to close and returns as soon as the tick function will not be called again; the driver may take
  /// longer. Not from within the tick function.
  virtual void beginClose() = 0;
  /// Switches the force output off and sends zero where it can, whatever the driver's thread does: the last
  /// act of a process that ends. Any thread; may hang with the driver.
  virtual void switchOff() noexcept = 0;
  /// Tells, without waiting, whether the force output of a device that is being closed is off. Any thread.
  [[nodiscard]] virtual bool silent() const noexcept = 0;
  /// Tells, without waiting, whether a device that is being closed has been let go of. Any thread.
  [[nodiscard]] virtual bool released() const = 0;

  void serve() override { start({}); }
};

/// A reading on its way from a driver's thread, numbered so that an old one is recognised.
struct MailedReading {
  DeviceSample sample;
  std::uint64_t number = 0;  ///< 0: none yet
};

/// The servo's end of a driver's readings: how long the newest one has been the newest. Servo thread.
class ReadingAge {
 public:
  /// `beforeFirst`: status bits while there is no reading yet; a reading is marked stale and lost when no
  /// other has come for longer than that.
  constexpr ReadingAge(std::uint32_t beforeFirst, std::int64_t stale_us, std::int64_t lost_us) noexcept
      : beforeFirst_(beforeFirst), stale_us_(stale_us), lost_us_(lost_us) {}

  /// Returns the newest reading as it counts at servo time `time_us`.
  [[nodiscard]] DeviceSample marked(const MailedReading& newest, std::int64_t time_us) noexcept {
    if (!read_ || newest.number != number_) {
      since_us_ = time_us;
    }
    read_ = true;
    number_ = newest.number;
    const std::int64_t age_us = time_us - since_us_;
    DeviceSample sample = newest.sample;
    sample.time_us = time_us;
    sample.status |= newest.number == 0 ? beforeFirst_ : 0U;
    sample.status |= age_us > stale_us_ ? static_cast<std::uint32_t>(kDeviceStale) : 0U;
    sample.status |= age_us > lost_us_ ? static_cast<std::uint32_t>(kDeviceLost) : 0U;
    return sample;
  }

 private:
  std::uint32_t beforeFirst_;
  std::int64_t stale_us_;
  std::int64_t lost_us_;
  std::uint64_t number_ = 0;
  std::int64_t since_us_ = 0;
  bool read_ = false;
};

/// A force on its way to a driver's thread, N in the world frame, numbered in the same way.
struct MailedForce {
  Vec3 force_N;
  std::uint64_t number = 0;
};

}  // namespace torsio
