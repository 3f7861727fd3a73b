// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/servo_labels.h"

namespace torsio {

Text refusedToServo(bool priority, bool memory) {
  if (priority && memory) {
    return {};
  }
  if (memory) {
    return Text::tr("the system refuses real-time priority");
  }
  return priority ? Text::tr("the system refuses to keep the servo in memory")
                  : Text::tr("the system refuses real-time priority and to keep the servo in memory");
}

Text grantRealTime() {
  return Text::tr("Copy assets/system/torsio-limits.conf to /etc/security/limits.d and log in again");
}

Text servoTrouble(const ServoHealth& health, std::int64_t ticks) {
  const bool skipped =
      static_cast<double>(health.skippedTicks) > kSkippedForgiven * static_cast<double>(ticks);
  if (health.forceCuts == 0 && !skipped) {
    return {};
  }
  const Text what = Text::tr(
      "the machine was too busy: the force was cut %1 {time|times}, %2 of %3 {tick was|ticks were} skipped",
      health.forceCuts, health.skippedTicks, ticks + health.skippedTicks);
  const Text refused = refusedToServo(health.priority, health.memory);
  return refused.empty() ? what : Text::verbatim("%1; %2", what, refused);
}

Text servoRemedy(const ServoHealth& health) {
  return health.priority && health.memory ? Text::tr("Close other programs at this station")
                                          : grantRealTime();
}

}  // namespace torsio
