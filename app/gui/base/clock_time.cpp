// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/clock_time.h"

namespace torsio::gui {

QString clockTime(std::int64_t time_us) {
  const std::int64_t seconds = time_us / 1'000'000;
  return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace torsio::gui
