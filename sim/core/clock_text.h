// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

// Times within a recording and durations below an hour, as minutes and seconds. What is measured or compared
// with a limit (a hold, a time to the target, a computing time) stays in seconds with its unit; planned
// durations are whole minutes in words. Any thread.

/// Elapsed time, rounded down to seconds: "2:05".
[[nodiscard]] std::string clockText(std::int64_t time_us);
/// Time left, rounded up to seconds: "2:05"; "0:00" when nothing is left.
[[nodiscard]] std::string clockLeftText(std::int64_t left_us);
/// To the nearest tenth: "2:05.4".
[[nodiscard]] std::string clockTenthsText(double time_s);

}  // namespace torsio
