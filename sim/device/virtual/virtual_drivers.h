// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/device_driver.h"

namespace torsio {

/// Mouse and keyboard.
[[nodiscard]] DeviceDriver pointerDriver();
/// A simulated hand, which comes from `start` and grasps at the centre of the workspace.
[[nodiscard]] DeviceDriver scriptedHandDriver();
/// What was recorded, tick by tick.
[[nodiscard]] DeviceDriver replayDriver();
/// Driver of IdleDevice: the instrument stays at `start`.
[[nodiscard]] DeviceDriver idleDriver();

}  // namespace torsio
