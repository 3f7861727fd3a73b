// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/device_driver.h"

namespace torsio {

/// Haply Inverse3 through its service on this computer (Inverse3Device); TORSIO_INVERSE_SERVICE names another
/// place as HOST:PORT. The name in a DeviceRequest is the device's id; "": the first one. Not confirmed on
/// hardware.
[[nodiscard]] DeviceDriver inverse3Driver();

}  // namespace torsio
