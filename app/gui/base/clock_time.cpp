// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/clock_time.h"

#include <cmath>

#include "sim/core/clock_text.h"
#include "sim/core/time_units.h"

namespace torsio::gui {

QString clockTime(std::int64_t time_us) {
  return QString::fromStdString(clockText(time_us));
}

QString clockTimeLeft(std::int64_t left_us) {
  return QString::fromStdString(clockLeftText(left_us));
}

QString clockTenths(double time_s) {
  const auto tenths = static_cast<std::int64_t>(std::llround(10.0 * time_s));  // 59.96 s are 1:00.0
  return clockTime(tenths / 10 * kSecond_us) + QStringLiteral(".%1").arg(tenths % 10);
}

QString clockTenthsOf(std::int64_t time_us) {
  return clockTenths(1e-6 * static_cast<double>(time_us));
}

}  // namespace torsio::gui
