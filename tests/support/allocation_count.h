// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio::testing {

/// Returns how often this thread has allocated through operator new since it started. Test programs with
/// allocation_count.cpp in their sources count; compare before and after.
[[nodiscard]] std::int64_t allocationCount() noexcept;

}  // namespace torsio::testing
