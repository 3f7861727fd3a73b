// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/live_types.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// Lets a scripted, practised hand reach, grip and twist the organ on a manual clock, through the same servo
/// loop as everything else, and returns the instant at which it holds the target (or the nearest it came). A
/// target of 0 returns the hand in contact, before the twist. An organ that came twisted is returned as it
/// lies at that angle, the hand not yet there. Takes a fraction of a second.
[[nodiscard]] LiveState scriptedTwist(const Scene& scene, double target_rad);

/// Returns the angle at which a pattern is shown: its target; of an organ that comes twisted one that it may
/// come with.
[[nodiscard]] double usualAngle_rad(const Scene& scene);

}  // namespace torsio::gui
