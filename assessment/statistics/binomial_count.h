// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace torsio {

/// Returns n over k, the number of subsets of size k; empty beyond 2^53, where doubles are no longer exact.
[[nodiscard]] std::optional<std::int64_t> binomialCount(std::int64_t n, std::int64_t k);

}  // namespace torsio
