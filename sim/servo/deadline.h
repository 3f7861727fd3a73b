// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio {

/// What a thread needs from the system to keep a rate. deadline_posix.cpp on Linux and other POSIX systems,
/// deadline_portable.cpp elsewhere.

/// Nanoseconds on the clock that the deadlines are given in.
[[nodiscard]] std::int64_t deadlineNow_ns() noexcept;

/// Sleeps until the deadline; returns at once when it has passed.
void sleepUntil(std::int64_t deadline_ns) noexcept;

/// Which of two real-time threads runs when both want to.
enum class RealTimeRank { kServo, kWatchdog };

/// Asks for real-time scheduling of the calling thread and for exact wake-ups. False when the system does not
/// permit real-time scheduling: the thread then runs like any other.
bool requestRealTime(RealTimeRank rank = RealTimeRank::kServo) noexcept;

/// Asks that the memory which the process uses now stays in memory, so that no tick waits for a disk, and
/// touches the calling thread's stack. Memory that is taken later is not locked: where the permitted amount
/// is small, its refusal would end the program. False when the system does not permit it: everything works, a
/// tick may once wait for a page.
bool lockMemory() noexcept;

}  // namespace torsio
