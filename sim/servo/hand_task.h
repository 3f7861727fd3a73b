// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/organ_pose.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Makes the task of the scene's twist pattern for a scripted hand, which grasps the section at
/// pattern.graspArc where the surface faces away from the axis of the twist and the way to it is free, and
/// turns by the target. Throws Error{kBadParameter} when no point of that section can be reached. Of an organ
/// that is undone: detorseTask of a trial without an id.
[[nodiscard]] HandTask handTask(const Scene& scene);
/// Makes the task of handTask(scene) up to another angle of the pattern: the hand turns by what the pattern's
/// measured angle needs.
[[nodiscard]] HandTask handTask(const Scene& scene, double angle_rad);

/// Makes the task of undoing a hollow organ as it comes in the trial of this seed (detorsionSeed): the least
/// number of equal turns, each within a hand's reach; the jaw as tight as the wall bears well. Throws as
/// handTask. `scene.hollow` is set.
[[nodiscard]] HandTask detorseTask(const Scene& scene, std::uint64_t seed);
/// Returns when a hand that undoes an organ has left it alone for as long as success asks, seconds after its
/// first read.
[[nodiscard]] double undone_s(const HollowOrgan& organ, const ScriptedHand& hand);

}  // namespace torsio
