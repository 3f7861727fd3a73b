// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio::testing {

/// How often this thread has asked for a mutex, a reader-writer lock or a condition since it started. A test
/// program that lists lock_count_posix.cpp among its sources (on Windows lock_count_other.cpp) counts;
/// compare before and after.
[[nodiscard]] std::int64_t lockCount() noexcept;

/// False where nothing is counted: on other platforms, and under a sanitizer that needs these functions
/// itself.
[[nodiscard]] bool lockCountWorks() noexcept;

}  // namespace torsio::testing
