// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/scene/scene.h"

namespace torsio::gui {

/// Returns the instrument's waiting position: in front of the section to grasp, on the viewer's side, two
/// centimetres clear of the organ in any initial state. World frame.
[[nodiscard]] Vec3 parkingPoint_m(const Scene& scene);

}  // namespace torsio::gui
