// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QString>

namespace torsio::gui {

// As sim/core/clock_text.h, for screens: a moment of a recording and how long it is go by tenths, so that a
// moment that one person chose is the same to another; clocks that run, and what is planned, by seconds. Any
// thread.

/// Whole seconds that are over: "2:05".
[[nodiscard]] QString clockTime(std::int64_t time_us);
/// Whole seconds that are still to come, begun ones too: "2:05"; "0:00" when nothing is left.
[[nodiscard]] QString clockTimeLeft(std::int64_t left_us);
/// To the nearest tenth: "2:05.4".
[[nodiscard]] QString clockTenths(double time_s);
[[nodiscard]] QString clockTenthsOf(std::int64_t time_us);

}  // namespace torsio::gui
