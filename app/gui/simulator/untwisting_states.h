// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "sim/core/live_types.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

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
