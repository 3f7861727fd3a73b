// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

// The one home of how a moment of a recording is written, and how long something took or still takes, below
// an hour: minutes and seconds. In seconds with their unit stay what is measured or set against a limit (a
// hold, a time to the target, a computing time), in words what is planned in whole minutes. Any thread.

/// Whole seconds that are over: "2:05".
[[nodiscard]] std::string clockText(std::int64_t time_us);
/// Whole seconds that are still to come, begun ones too: "2:05"; "0:00" when nothing is left.
[[nodiscard]] std::string clockLeftText(std::int64_t left_us);
/// To the nearest tenth: "2:05.4".
[[nodiscard]] std::string clockTenthsText(double time_s);

}  // namespace torsio
