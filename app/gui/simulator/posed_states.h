// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>

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

/// States of an organ that comes twisted, for screenshots.
enum class UntwistingState : std::uint8_t {
  kRest,       ///< untwisted and healthy
  kOnset,      ///< the wall begins to fold; for a cord, a quarter of its largest twist
  kClosed,     ///< the narrowest place is closed; for a cord, half of its largest twist
  kIschaemic,  ///< maximum initial twist, for a long time; in a scene without ischaemia, congested
  kRecovered,  ///< untwisted afterwards, with restored flow
};
inline constexpr std::array<std::pair<UntwistingState, const char*>, 5> kUntwistingStates{
    {{UntwistingState::kRest, "rest"},
     {UntwistingState::kOnset, "onset"},
     {UntwistingState::kClosed, "closed"},
     {UntwistingState::kIschaemic, "ischaemic"},
     {UntwistingState::kRecovered, "recovered"}}};

/// Returns the organ in a state, twisted in the usual direction, without a hand. `scene` must have a hollow
/// organ.
[[nodiscard]] LiveState untwistingState(const Scene& scene, UntwistingState state);

}  // namespace torsio::gui
