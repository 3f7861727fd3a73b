// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio::testing {

/// How often this thread has taken memory through operator new since it started. A test program that lists
/// allocation_count.cpp among its sources counts; compare before and after.
[[nodiscard]] std::int64_t allocationCount() noexcept;

}  // namespace torsio::testing
