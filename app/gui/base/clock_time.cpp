// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/clock_time.h"

#include <algorithm>
#include <cmath>

#include "sim/base/time_units.h"

namespace torsio::gui {

QString clockTime(std::int64_t time_us) {
  const std::int64_t seconds = time_us / kSecond_us;
  return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

QString clockTimeLeft(std::int64_t left_us) {
  return clockTime(std::max<std::int64_t>(0, left_us) + kSecond_us - 1);
}

QString clockTenths(double time_s) {
  const auto tenths = static_cast<std::int64_t>(std::llround(10.0 * time_s));  // 59.96 s are 1:00.0
  return clockTime(tenths / 10 * kSecond_us) + QStringLiteral(".%1").arg(tenths % 10);
}

}  // namespace torsio::gui
