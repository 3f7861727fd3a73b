// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace torsio {

// Distribution functions in double precision, identical on every platform. "Upper" is the upper tail,
// accurate also where it is tiny. Contract: arguments are finite; degrees of freedom and probabilities are in
// range.

[[nodiscard]] double normalDensity(double x);
[[nodiscard]] double normalCdf(double x);
[[nodiscard]] double normalUpper(double x);
[[nodiscard]] double normalQuantile(double p);
/// Returns the two-sided p value of a standard normal statistic.
[[nodiscard]] double normalTwoSided(double z);

[[nodiscard]] double tQuantile(double p, double df);
[[nodiscard]] double tTwoSided(double t, double df);

[[nodiscard]] double fUpper(double f, double df1, double df2);
[[nodiscard]] double fQuantile(double p, double df1, double df2);

[[nodiscard]] double chiSquaredUpper(double x, double df);
[[nodiscard]] double chiSquaredQuantile(double p, double df);

[[nodiscard]] double noncentralTCdf(double t, double df, double noncentrality);
[[nodiscard]] double noncentralTUpper(double t, double df, double noncentrality);
[[nodiscard]] double noncentralTQuantile(double p, double df, double noncentrality);
[[nodiscard]] double noncentralFCdf(double f, double df1, double df2, double noncentrality);
/// Returns the noncentrality d with P(T <= t; df, d) = p.
[[nodiscard]] double noncentralityOfT(double t, double df, double p);

/// The studentised range of `groups` means: Gauss-Legendre over both integrals, the inner one cached
/// (Chebyshev interpolation of its logarithm), as 60 groups with 1,770 pairs require. Absolute error below
/// 1e-12. Not thread-safe.
class StudentizedRange {
 public:
  /// `groups` >= 2.
  explicit StudentizedRange(int groups);

  /// Returns the upper tail at q, with `df` >= 1 error degrees of freedom.
  [[nodiscard]] double upper(double q, double df);
  /// Returns q with lower tail p, 0 < p < 1.
  [[nodiscard]] double quantile(double p, double df);

 private:
  static constexpr std::size_t kTerms = 14;  // of an interpolation panel

  [[nodiscard]] double logRangeUpper(double w);
  const std::array<double, kTerms>& panel(std::size_t number);

  int groups_;
  std::vector<std::optional<std::array<double, kTerms>>>
      panels_;  // Chebyshev coefficients of the log of the range's upper tail
};

}  // namespace torsio
