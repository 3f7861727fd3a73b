// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/held_up.h"

#include "app/services/devices/device_choice.h"
#include "assessment/results/number_format.h"

namespace torsio {

namespace {

// A sleep that takes this much longer is no accident.
constexpr std::int64_t kNoAccident_us = 50'000;
// Sum from which a servo, which must be called every millisecond, has suffered, too.
constexpr std::int64_t kStarved_us = 250'000;
// What was longer ago does not explain why a device is lost now.
constexpr std::int64_t kRecently_us = 2'000'000;

}  // namespace

void HeldUp::pause_s(double seconds) {
  const std::int64_t from_us = clock_.now_us();
  torsio::pause_s(seconds);
  const std::int64_t late_us = clock_.now_us() - from_us - static_cast<std::int64_t>(1e6 * seconds);
  if (late_us > kNoAccident_us) {
    late_us_ = recently() ? late_us_ + late_us : late_us;
    newest_us_ = clock_.now_us();
  }
}

bool HeldUp::recently() const {
  return clock_.now_us() - newest_us_ <= kRecently_us;
}

bool HeldUp::starved() const {
  return recently() && late_us_ >= kStarved_us;
}

Text HeldUp::sentence() const {
  return Text::tr("the computer was too busy: it gave Torsio no time for %1 s, and the device fell silent",
                  formatFixed(1e-6 * static_cast<double>(late_us_), 1));
}

Text HeldUp::remedy() {
  return Text::tr(
      "Close other programs; on Linux allow real-time scheduling for this user (docs/devices.md)");
}

}  // namespace torsio
