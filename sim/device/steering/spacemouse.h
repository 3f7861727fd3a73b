// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/device_driver.h"

namespace torsio {

/// SpaceMouse, SpaceNavigator and other pucks with six axes, through the daemon spacenavd and its library
/// libspnav (protocol 0 or 1). The socket is the one that SPNAV_SOCKET names, else the daemon's usual one.
/// One at a time in a process: that is the library's rule. Not confirmed on hardware.
/// docs/devices.md says what its motions and buttons do.
[[nodiscard]] DeviceDriver spaceMouseDriver();

}  // namespace torsio
