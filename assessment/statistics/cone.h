// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace torsio {

/// One row of a system of linear inequalities: each unknown with its coefficient, zeros left out.
using SparseRow = std::vector<std::pair<std::size_t, int>>;

/// Finds a direction y, not zero, with row . y <= 0 for every row; empty when y = 0 alone satisfies them all.
/// Exact: whole numbers and fractions decide, no rounding. Unknowns are numbered from 0 to `unknowns` - 1.
[[nodiscard]] std::optional<std::vector<double>> directionWithin(const std::vector<SparseRow>& rows,
                                                                 std::size_t unknowns);

}  // namespace torsio
