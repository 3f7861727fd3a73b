// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "sim/device/device_driver.h"
#include "sim/device/hosted_device.h"

namespace torsio {

/// Haply Inverse3 through its service on this computer (Inverse3Device); TORSIO_INVERSE_SERVICE names another
/// place as HOST:PORT. The name in a DeviceRequest is the device's id; "": the first one. Not confirmed on
/// hardware. Its thread runs in this process; `hosted` (sim/device/process) moves it into the device process.
[[nodiscard]] DeviceDriver inverse3Driver();
/// Opens the device as the driver does. Throws Error{kDevice} or Error{kBadParameter}.
[[nodiscard]] std::unique_ptr<HostedDevice> openInverse3(const DeviceRequest& request);

}  // namespace torsio
