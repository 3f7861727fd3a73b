// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/device_driver.h"

namespace torsio {

/// PHANTOM Omni and 3D Systems Touch, their vendor's library in the device process.
[[nodiscard]] DeviceDriver stylusDeviceDriver();

}  // namespace torsio
