// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "db/connection/row_reader.h"
#include "sim/core/servo_health.h"

namespace torsio {

/// Columns of trial_end (as `alias`) about the timing of the servo, in the order of servoHealthOf().
inline std::string servoHealthColumns(const std::string& alias) {
  return alias + ".real_time_priority, " + alias + ".memory_locked, " + alias + ".skipped_ticks, " + alias +
         ".force_cuts";
}
inline constexpr int kServoHealthColumns = 4;

/// Empty for a trial that did not run in real time or has no closing row.
inline std::optional<ServoHealth> servoHealthOf(RowReader& row) {
  if (row.nextIsNull()) {
    row.skip(kServoHealthColumns);
    return std::nullopt;
  }
  ServoHealth health;
  health.priority = row.boolean();
  health.memory = row.boolean();
  health.skippedTicks = row.int64();
  health.forceCuts = row.int64();
  return health;
}

}  // namespace torsio
