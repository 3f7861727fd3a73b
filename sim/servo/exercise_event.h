// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/core/live_types.h"

namespace torsio {

/// What happened in one tick; bits of ExerciseStep::events.
enum ExerciseEvent : std::uint32_t {
  kEventNone = 0,
  kEventTouched = 1U << 0,   ///< Tracking to Contact
  kEventLeft = 1U << 1,      ///< Contact to Tracking
  kEventGripped = 1U << 2,   ///< Contact to Twisting: the jaw holds the organ
  kEventReleased = 1U << 3,  ///< Twisting to Released: the jaw opened, or a view or a lost device let go
  kEventSlipped = 1U << 4,   ///< with kEventReleased: the tool pulled itself free
  kEventReturned = 1U << 5,  ///< the organ is at rest again
  kEventShaftTouched = 1U << 6,
  kEventShaftLeft = 1U << 7,
  kEventFolded = 1U << 8,  ///< with kEventReleased: the tissue would have folded, or slipped back by a turn
  // Of a hollow organ that came twisted.
  kEventBruised = 1U << 9,     ///< the jaw has pressed too hard for too long
  kEventTorn = 1U << 10,       ///< through the wall: the content leaves
  kEventClipped = 1U << 11,    ///< a clip or an assistant holds the mobile part
  kEventUnclipped = 1U << 12,  ///< and has let go
  kEventChecked = 1U << 13,    ///< a check of the blood flow has its answer
  kEventRelapsing = 1U << 14,  ///< the mobile part begins to turn back by itself
};

/// Events of one tick with their time, for readers that must not miss one.
struct ExerciseMoment {
  std::int64_t tick = 0;
  std::int64_t time_us = 0;
  std::uint32_t events = kEventNone;               ///< ExerciseEvent bits
  ExercisePhase phase = ExercisePhase::kTracking;  ///< after them
  friend constexpr bool operator==(const ExerciseMoment&, const ExerciseMoment&) = default;
};
static_assert(std::is_trivially_copyable_v<ExerciseMoment>);

}  // namespace torsio
