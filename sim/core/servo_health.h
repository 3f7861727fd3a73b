// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio {

/// How well a machine kept the deadlines of a real-time servo.
struct ServoHealth {
  bool priority = false;          ///< the system granted real-time priority
  bool memory = false;            ///< the servo is locked in memory
  std::int64_t skippedTicks = 0;  ///< deadlines missed by a whole period, and skipped
  std::int64_t forceCuts = 0;     ///< pauses after which the force is zero and comes back by a ramp
  friend bool operator==(const ServoHealth&, const ServoHealth&) = default;
};

}  // namespace torsio
