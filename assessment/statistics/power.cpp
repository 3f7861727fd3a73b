// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/power.h"

#include <cmath>
#include <cstdint>

#include <boost/math/tools/roots.hpp>

#include "assessment/statistics/distributions.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr double kMinPairs = 1.5;  // two after rounding up

double powerOfT(double noncentrality, double df, double alpha) {
  const double critical = tQuantile(1.0 - 0.5 * alpha, df);
  return noncentralTUpper(critical, df, noncentrality) + noncentralTCdf(-critical, df, noncentrality);
}

/// Root of a rising function above `low`; `low` itself if the function is not negative there.
template <class Function>
double solveRising(const Function& f, double low) {
  if (f(low) >= 0.0) {
    return low;
  }
  double high = 2.0 * low + 1.0;
  while (f(high) < 0.0) {
    low = high;
    high *= 2.0;
    TORSIO_EXPECTS(high < 1e9);
  }
  std::uintmax_t iterations = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, low, high, boost::math::tools::eps_tolerance<double>(48), iterations);
  return 0.5 * (a + b);
}

}  // namespace

double powerTwoSampleT(double n, double d, double alpha) {
  TORSIO_EXPECTS(n > 1.0 && alpha > 0.0 && alpha < 1.0);
  return powerOfT(d * std::sqrt(0.5 * n), 2.0 * (n - 1.0), alpha);
}

double sizeTwoSampleT(double d, double power, double alpha) {
  TORSIO_EXPECTS(d > 0.0 && power > alpha && power < 1.0);
  return solveRising([&](double n) { return powerTwoSampleT(n, d, alpha) - power; }, 1.5);
}

double detectableTwoSampleT(double n, double power, double alpha) {
  TORSIO_EXPECTS(power > alpha && power < 1.0);
  return solveRising([&](double d) { return powerTwoSampleT(n, d, alpha) - power; }, 0.0);
}

double detectableStandardErrors(double df, double power, double alpha) {
  TORSIO_EXPECTS(df > 0.0 && power > alpha && power < 1.0);
  return solveRising([&](double errors) { return powerOfT(errors, df, alpha) - power; }, 0.0);
}

double powerPairedT(double pairs, double d, double alpha) {
  TORSIO_EXPECTS(pairs > 1.0);
  return powerOfT(d * std::sqrt(pairs), pairs - 1.0, alpha);
}

double detectablePairedT(double pairs, double power, double alpha) {
  TORSIO_EXPECTS(power > alpha && power < 1.0);
  return solveRising([&](double d) { return powerPairedT(pairs, d, alpha) - power; }, 0.0);
}

double sizePairedT(double d, double power, double alpha) {
  TORSIO_EXPECTS(d > 0.0 && power > alpha && power < 1.0);
  return solveRising([&](double pairs) { return powerPairedT(pairs, d, alpha) - power; }, kMinPairs);
}

double powerAnova(int groups, double n, double f, double alpha) {
  TORSIO_EXPECTS(groups >= 2 && n > 1.0);
  const double k = static_cast<double>(groups);
  const double df1 = k - 1.0;
  const double df2 = k * (n - 1.0);
  const double critical = fQuantile(1.0 - alpha, df1, df2);
  return 1.0 - noncentralFCdf(critical, df1, df2, k * n * f * f);
}

double sizeAnova(int groups, double f, double power, double alpha) {
  TORSIO_EXPECTS(f > 0.0 && power > alpha && power < 1.0);
  return solveRising([&](double n) { return powerAnova(groups, n, f, alpha) - power; }, 1.5);
}

double detectableAnova(int groups, double n, double power, double alpha) {
  TORSIO_EXPECTS(power > alpha && power < 1.0);
  return solveRising([&](double f) { return powerAnova(groups, n, f, alpha) - power; }, 0.0);
}

double sizeWithCovariate(double sizeWithout, double rho) {
  TORSIO_EXPECTS(rho > -1.0 && rho < 1.0);
  return sizeWithout * (1.0 - rho * rho);
}

double sizeIccWidth(double icc, int raters, double width, double confidence) {
  TORSIO_EXPECTS(raters >= 2 && width > 0.0);
  const double k = static_cast<double>(raters);
  const double z = normalQuantile(0.5 * (1.0 + confidence));
  const double spread = (1.0 - icc) * (1.0 + (k - 1.0) * icc);
  return 8.0 * z * z * spread * spread / (k * (k - 1.0) * width * width) + 1.0;
}

}  // namespace torsio
