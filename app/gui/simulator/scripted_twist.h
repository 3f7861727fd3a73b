// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/live_types.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// Lets a scripted, practised hand reach, grip and twist the organ on a manual clock, through the normal
/// servo loop, and returns the state in which it holds the target (or came nearest). For a target of 0,
/// returns the hand in contact before the twist. An organ that comes twisted is returned at that angle,
/// without the hand. Takes a fraction of a second.
[[nodiscard]] LiveState scriptedTwist(const Scene& scene, double target_rad);

/// Returns the angle to display for a pattern: its target; for an organ that comes twisted, one of its
/// possible angles.
[[nodiscard]] double usualAngle_rad(const Scene& scene);

}  // namespace torsio::gui
