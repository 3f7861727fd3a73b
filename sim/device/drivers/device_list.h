// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/device/device_driver.h"

namespace torsio {

/// Lists all drivers, best first. Looks for nothing: DeviceDriver::look does.
[[nodiscard]] const std::vector<DeviceDriver>& deviceDrivers();
/// Finds the driver of this id. Throws Error{kBadParameter} that names the ids there are.
[[nodiscard]] const DeviceDriver& deviceDriver(const std::string& id);

}  // namespace torsio
