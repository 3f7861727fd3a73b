// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "sim/core/live_types.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// What an organ that comes twisted goes through, for pictures.
enum class UntwistingState : std::uint8_t {
  kRest,       ///< untwisted and sound
  kOnset,      ///< the wall begins to fold; of a cord a quarter of its largest twist
  kClosed,     ///< the narrowest place is shut; of a cord half of its largest twist
  kIschaemic,  ///< as far as it may come twisted, and long so; of a scene that never starves: dammed up
  kRecovered,  ///< undone after that, flow come back
};
inline constexpr std::array<std::pair<UntwistingState, const char*>, 5> kUntwistingStates{
    {{UntwistingState::kRest, "rest"},
     {UntwistingState::kOnset, "onset"},
     {UntwistingState::kClosed, "closed"},
     {UntwistingState::kIschaemic, "ischaemic"},
     {UntwistingState::kRecovered, "recovered"}}};

/// Returns the organ in a state, twisted the usual way, nobody's hand on it. `scene` has a hollow organ.
[[nodiscard]] LiveState untwistingState(const Scene& scene, UntwistingState state);

}  // namespace torsio::gui
