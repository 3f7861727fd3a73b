// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/device_driver.h"

namespace torsio {

/// Game controllers through SDL2 (2.0.14 or later, its game controller interface, which knows the layout of
/// some hundred models). Not confirmed on hardware.
/// docs/devices.md lists what each stick and button does.
///
/// The name in a DeviceRequest is that of the controller as SDL gives it; "": the first one.
[[nodiscard]] DeviceDriver gameControllerDriver();

}  // namespace torsio
