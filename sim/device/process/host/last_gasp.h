// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/hosted_device.h"
#include "sim/device/process/device_channel.h"

namespace torsio {

/// From here on every end of this process that can be heard - exit(), quick_exit(), an exception that nobody
/// catches, any signal that would end it - switches the device's force off first, in a thread of its own,
/// because the one that ends may hold the library's lock. What cannot be heard (_exit(), SIGKILL, a library
/// that takes the signals for itself) is left to the program's second hand. Once, after the driver's thread
/// was started; both objects stay until the process ends.
void armLastGasp(HostedDevice& device, DeviceChannel& channel);

/// Gives the calling thread a stack for signals, so that one that ran out of its own is heard, too.
void useSignalStack() noexcept;

}  // namespace torsio
