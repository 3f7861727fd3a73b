// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace torsio {

/// Adjusts p values by Bonferroni, in the order given; the family must be fixed before anybody looks at the
/// data.
[[nodiscard]] std::vector<double> adjustBonferroni(std::span<const double> p);
[[nodiscard]] std::vector<double> adjustHolm(std::span<const double> p);      ///< family-wise error
[[nodiscard]] std::vector<double> adjustHochberg(std::span<const double> p);  ///< independent tests
[[nodiscard]] std::vector<double> adjustBenjaminiHochberg(
    std::span<const double> p);  ///< false discovery rate

}  // namespace torsio
