// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

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
  /// Tells, without waiting, whether a device that is being closed has been let go of. Any thread.
  [[nodiscard]] virtual bool released() const = 0;

  void serve() override { start({}); }
};

}  // namespace torsio
