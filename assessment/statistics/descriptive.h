// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// Share of a sum of squares that rounding may leave where nothing is left.
inline constexpr double kLeftByRounding = 1e-14;

/// Computes the mean with compensated summation; values must not be empty.
[[nodiscard]] double meanOf(std::span<const double> values);
/// Computes the sum of squares about the mean in two passes with correction; robust to large offsets.
[[nodiscard]] double sumOfSquares(std::span<const double> values);
/// Returns an upper bound of the sum of squares caused by rounding decimals to doubles; anything up to it is
/// no
/// variation.
[[nodiscard]] double roundingSquares(std::span<const double> values);
/// Returns the sum of squares about the mean; 0 if it may be due to rounding alone.
[[nodiscard]] double squaresBeyondRounding(std::span<const double> values);
/// Computes the variance with divisor n - 1; empty for fewer than two values.
[[nodiscard]] std::optional<double> sampleVariance(std::span<const double> values);
[[nodiscard]] std::optional<double> sampleDeviation(std::span<const double> values);
/// Returns the middle value; values must not be empty.
[[nodiscard]] double medianOf(std::span<const double> values);

/// Returns why statistics of these numbers would overflow or underflow; empty if they would not. Variances of
/// variances are formed, so the fourth power of the largest number must be finite and that of the spread must
/// not vanish.
[[nodiscard]] std::optional<Text> beyondArithmetic(std::span<const double> values);
[[nodiscard]] std::optional<Text> beyondArithmetic(std::span<const double> x, std::span<const double> y);
[[nodiscard]] std::optional<Text> beyondArithmetic(const std::vector<std::vector<double>>& groups);

/// Ranks times two, so that midranks of ties are integers.
struct DoubledRanks {
  std::vector<std::int64_t> ranks;
  std::int64_t tieTerm = 0;  ///< sum of t^3 - t over groups of t equal values
};

/// Ranks values; only equal doubles tie. Form differences of decimals as integers first (see exactGains): 6.9
/// - 5.1 and 7.0 - 5.2 are different doubles.
[[nodiscard]] DoubledRanks doubledRanks(std::span<const double> values);

/// Converts decimals, and means of up to 60 of them, to integers: multiplies all values by the smallest such
/// number times a power of ten, up to 10^6, that makes them integers to within rounding. Empty if there is
/// none.
[[nodiscard]] std::optional<std::vector<std::int64_t>> asWholeNumbers(std::span<const double> values);

}  // namespace torsio
