// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/core/beside_answer.h"
#include "sim/core/latest_value.h"

namespace torsio {

/// What the servo tells a model beside it, each tick.
struct BesideQuestion {
  std::int64_t grip = 0;   ///< 1, 2 ... of the run; 0: nothing was gripped yet
  double arc_m = 0.0;      ///< gripped section, from the fixed end
  double angle_rad = 0.0;  ///< its turn now; 0 again when the organ is back at rest
};

/// An answer on its way to the servo.
struct BesideDelivery {
  std::int64_t number = 0;  ///< 1, 2 ... of the run; 0: none yet
  std::int64_t grip = 0;    ///< that it was computed for
  BesideAnswer answer;
};
static_assert(std::is_trivially_copyable_v<BesideQuestion> && std::is_trivially_copyable_v<BesideDelivery>);

/// The two mailboxes between the servo and a model that runs beside it: neither ever waits for the other.
struct BesideLink {
  LatestValue<BesideQuestion> questions;   ///< servo -> model
  LatestValue<BesideDelivery> deliveries;  ///< model -> servo
};

}  // namespace torsio
