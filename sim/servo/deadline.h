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

/// Asks for real-time scheduling of the calling thread and for exact wake-ups. False when the system does not
/// permit real-time scheduling: the thread then runs like any other.
bool requestRealTime() noexcept;

}  // namespace torsio
