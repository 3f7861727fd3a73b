// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/core/latest_value.h"

namespace torsio {

enum class AsyncState : std::uint8_t {
  kNothing = 0,  ///< nothing arrived
  kSound = 1,    ///< the numbers are finite
  kBroken = 2,   ///< the model has failed or said something that is no number; the others are then 0
};

/// What an asynchronous model says of the grip: an input of the tick in which it arrives, recorded with
/// that tick as the device's sample is. SI.
struct AsyncAnswer {
  AsyncState state = AsyncState::kNothing;
  double angle_rad = 0.0;         ///< at which it was computed
  double torque_Nm = 0.0;         ///< of the jaw there
  double slope_Nm_per_rad = 0.0;  ///< of the torque over the angle
  friend constexpr bool operator==(const AsyncAnswer&, const AsyncAnswer&) = default;
};
static_assert(std::is_trivially_copyable_v<AsyncAnswer>);

/// What the servo tells a model beside it, each tick.
struct AsyncQuestion {
  std::int64_t grip = 0;   ///< 1, 2 ... of the run; 0: nothing was gripped yet
  double arc_m = 0.0;      ///< gripped section, from the fixed end
  double angle_rad = 0.0;  ///< its turn now; 0 again when the organ is back at rest
};

/// An answer on its way to the servo.
struct AsyncDelivery {
  std::int64_t number = 0;  ///< 1, 2 ... of the run; 0: none yet
  std::int64_t grip = 0;    ///< that it was computed for
  AsyncAnswer answer;
};
static_assert(std::is_trivially_copyable_v<AsyncQuestion> && std::is_trivially_copyable_v<AsyncDelivery>);

/// The two mailboxes between the servo and a model that runs beside it: neither ever waits for the other.
struct AsyncLink {
  LatestValue<AsyncQuestion> questions;   ///< servo -> model
  LatestValue<AsyncDelivery> deliveries;  ///< model -> servo
};

}  // namespace torsio
