// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio::testing {

/// Returns how often this thread has requested a mutex, a reader-writer lock or a condition variable since it
/// started. Test programs with lock_count_posix.cpp in their sources (on Windows lock_count_other.cpp) count;
/// compare before and after.
[[nodiscard]] std::int64_t lockCount() noexcept;

/// False if counting is not available: on other platforms, and under a sanitizer that needs these functions
/// itself.
[[nodiscard]] bool lockCountWorks() noexcept;

}  // namespace torsio::testing
