// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/clock_time.h"

#include "sim/core/clock.h"

namespace torsio::gui {

QString clockTime(std::int64_t time_us) {
  return QString::fromStdString(clockText(time_us));
}

QString clockTimeLeft(std::int64_t left_us) {
  return QString::fromStdString(clockLeftText(left_us));
}

QString clockTenths(double time_s) {
  return QString::fromStdString(clockTenthsText(time_s));
}

QString clockTenthsOf(std::int64_t time_us) {
  return clockTenths(1e-6 * static_cast<double>(time_us));
}

}  // namespace torsio::gui
