// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace torsio {

/// The nine rules of Hyndman and Fan (1996). Type 7 is the default of R, NumPy and Excel INC.
enum class QuantileRule : int { kType1 = 1, kType2, kType3, kType4, kType5, kType6, kType7, kType8, kType9 };

inline constexpr QuantileRule kReportQuantileRule = QuantileRule::kType7;

/// Returns the p-quantile, 0 <= p <= 1, of finite values in any order; empty if there are none.
[[nodiscard]] std::optional<double> quantile(std::span<const double> values, double p,
                                             QuantileRule rule = kReportQuantileRule);

/// Numbers of a box plot: box at the quartiles, whiskers to the most extreme values within 1.5 interquartile
/// ranges of the box, values beyond as outliers.
struct BoxNumbers {
  std::int64_t n = 0;
  double min = 0.0;
  double whiskerLow = 0.0;
  double q1 = 0.0;
  double median = 0.0;
  double q3 = 0.0;
  double whiskerHigh = 0.0;
  double max = 0.0;
  double mean = 0.0;
  std::vector<double> outliers;  ///< ascending
};

[[nodiscard]] std::optional<BoxNumbers> boxNumbers(std::span<const double> values,
                                                   QuantileRule rule = kReportQuantileRule);

}  // namespace torsio
