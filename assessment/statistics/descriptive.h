// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// Computes the mean with compensated summation; values must not be empty.
[[nodiscard]] double meanOf(std::span<const double> values);
/// Computes the sum of squares about the mean, in two passes with correction, so that large offsets do no
/// harm.
[[nodiscard]] double sumOfSquares(std::span<const double> values);
/// Returns the squares that rounding of decimals to doubles alone may leave, summed: what is no larger is no
/// variation.
[[nodiscard]] double roundingSquares(std::span<const double> values);
/// The sum of squares about the mean as tests of means take it: 0 where rounding alone may leave it.
[[nodiscard]] double squaresBeyondRounding(std::span<const double> values);
/// Computes the variance with divisor n - 1; empty for fewer than two values.
[[nodiscard]] std::optional<double> sampleVariance(std::span<const double> values);
[[nodiscard]] std::optional<double> sampleDeviation(std::span<const double> values);
/// Returns the middle value; values must not be empty.
[[nodiscard]] double medianOf(std::span<const double> values);

/// Returns why statistics of these numbers cannot be computed, or nothing. Variances of variances are formed,
/// so the fourth power of the largest number must be finite and that of the spread must not vanish.
[[nodiscard]] std::optional<Text> beyondArithmetic(std::span<const double> values);
[[nodiscard]] std::optional<Text> beyondArithmetic(std::span<const double> x, std::span<const double> y);
[[nodiscard]] std::optional<Text> beyondArithmetic(const std::vector<std::vector<double>>& groups);

/// Ranks times two: whole numbers even where ties share a middle rank.
struct DoubledRanks {
  std::vector<std::int64_t> ranks;
  std::int64_t tieTerm = 0;  ///< sum of t^3 - t over groups of t equal values
};

/// Ranks values; only equal doubles tie. Differences of decimals must be formed in whole numbers first (see
/// exactGains): 6.9 - 5.1 and 7.0 - 5.2 are not the same double.
[[nodiscard]] DoubledRanks doubledRanks(std::span<const double> values);

/// Converts decimals to whole numbers: every value times the smallest power of ten, up to 10^6, that makes
/// all of them whole to within rounding of the double. Empty when a value has more decimals.
[[nodiscard]] std::optional<std::vector<std::int64_t>> asWholeNumbers(std::span<const double> values);

}  // namespace torsio
