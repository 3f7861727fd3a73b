// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace torsio {

/// One row of a system of linear inequalities: index and coefficient of each unknown, zeros omitted.
using SparseRow = std::vector<std::pair<std::size_t, int>>;

/// Finds a direction y != 0 with row . y <= 0 for every row; empty if only y = 0 satisfies them. Exact
/// (integers and fractions). Unknowns are numbered from 0 to `unknowns` - 1.
[[nodiscard]] std::optional<std::vector<double>> directionWithin(const std::vector<SparseRow>& rows,
                                                                 std::size_t unknowns);

}  // namespace torsio
