// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

// Private to assessment/statistics.
namespace torsio {

/// Squared relative difference ((a - b) / (a + b))^2 of two values; 0 if their sum is 0.
[[nodiscard]] double ratioDifference2(double a, double b);

/// Sums the squared relative differences over all ordered pairs of values, `counts[c]` of `values[c]`. Values
/// are distinct and ascending. Relative error below 1e-12. Linear time for thousands of nonnegative values,
/// otherwise quadratic.
[[nodiscard]] double sumOfRatioDifferences2(std::span<const double> values, std::span<const double> counts);

}  // namespace torsio
