// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/device_driver.h"

namespace torsio {

/// Game controllers through SDL2 (2.0.14 or later, its game controller interface, which knows the layout of
/// some hundred models). Not confirmed on hardware.
///
/// | part of the controller    | what it does                                             |
/// |---------------------------|----------------------------------------------------------|
/// | left stick                | tip to the right and left, up and down                   |
/// | right stick               | turn about the stylus; tip away from the user, towards   |
/// | directional pad           | tilt of the stylus                                       |
/// | right trigger             | jaw, graded                                              |
/// | left trigger              | slower, down to a quarter: for fine work                 |
/// | A (lower), Y (upper)      | second button, bookmark                                  |
///
/// The name in a DeviceRequest is that of the controller as SDL gives it; "": the first one.
[[nodiscard]] DeviceDriver gameControllerDriver();

}  // namespace torsio
