// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio {

/// How a machine kept the time of a servo that ran in real time.
struct ServoHealth {
  bool priority = false;          ///< the system granted real-time priority
  bool memory = false;            ///< the system granted to keep the servo in memory
  std::int64_t skippedTicks = 0;  ///< deadlines that had passed by a whole period: never caught up
  std::int64_t forceCuts = 0;     ///< pauses after which the force is zero and comes back by a ramp
  friend bool operator==(const ServoHealth&, const ServoHealth&) = default;
};

}  // namespace torsio
