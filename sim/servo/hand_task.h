// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/virtual/scripted_hand.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Makes the task of the scene's twist pattern for a scripted hand, which grasps the section at
/// pattern.graspArc where the surface faces away from the axis of the twist and the way to it is free, and
/// turns by the target. Throws Error{kBadParameter} when no point of that section can be reached.
[[nodiscard]] HandTask handTask(const Scene& scene);
/// Makes the task of handTask(scene) up to another angle of the pattern: the hand turns by what the pattern's
/// measured angle needs.
[[nodiscard]] HandTask handTask(const Scene& scene, double angle_rad);

}  // namespace torsio
