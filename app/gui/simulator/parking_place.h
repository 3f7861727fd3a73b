// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/scene/scene.h"

namespace torsio::gui {

/// Where the instrument waits before a run: in front of the section to grasp, on the side of the viewer, two
/// centimetres clear of the organ however it may lie. World frame.
[[nodiscard]] Vec3 parkingPoint_m(const Scene& scene);

}  // namespace torsio::gui
