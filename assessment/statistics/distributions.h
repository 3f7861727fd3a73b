// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

// Distribution functions in double precision, the same on every platform. "Upper" is the upper tail, accurate
// also where it is tiny. Arguments are finite; degrees of freedom and probabilities lie in their ranges
// (contract).

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

[[nodiscard]] double noncentralTCdf(double t, double df, double noncentrality);
[[nodiscard]] double noncentralTUpper(double t, double df, double noncentrality);
[[nodiscard]] double noncentralTQuantile(double p, double df, double noncentrality);
[[nodiscard]] double noncentralFCdf(double f, double df1, double df2, double noncentrality);
/// Returns the noncentrality d for which P(T <= t; df, d) = p.
[[nodiscard]] double noncentralityOfT(double t, double df, double p);

/// Returns the upper tail of the studentised range of `groups` means with `df` error degrees of freedom:
/// Gauss-Legendre over both integrals, absolute error below 1e-12.
[[nodiscard]] double studentizedRangeUpper(double q, int groups, double df);
[[nodiscard]] double studentizedRangeQuantile(double p, int groups, double df);

}  // namespace torsio
