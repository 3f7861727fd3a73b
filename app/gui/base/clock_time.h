// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QString>

namespace torsio::gui {

// Like sim/core/clock.h, for screens: moments and durations of a recording are shown in tenths, so that
// people can refer to the same moment; running clocks and plans in whole seconds. Thread-safe.

/// Rounds down to whole seconds: "2:05".
[[nodiscard]] QString clockTime(std::int64_t time_us);
/// Rounds up to whole seconds: "2:05"; "0:00" when nothing is left.
[[nodiscard]] QString clockTimeLeft(std::int64_t left_us);
/// Rounds to tenths: "2:05.4".
[[nodiscard]] QString clockTenths(double time_s);
[[nodiscard]] QString clockTenthsOf(std::int64_t time_us);

}  // namespace torsio::gui
