// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/distributions.h"

#include <cmath>
#include <cstdint>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>

#include "sim/base/contracts.h"

namespace torsio {

namespace {

namespace bm = boost::math;

// Without promotion to long double: that type has other widths on other platforms.
using Policy = bm::policies::policy<bm::policies::promote_double<false>, bm::policies::promote_float<false>>;
using Normal = bm::normal_distribution<double, Policy>;
using StudentT = bm::students_t_distribution<double, Policy>;
using FisherF = bm::fisher_f_distribution<double, Policy>;
using ChiSquared = bm::chi_squared_distribution<double, Policy>;
using NoncentralT = bm::non_central_t_distribution<double, Policy>;
using NoncentralF = bm::non_central_f_distribution<double, Policy>;

constexpr double kTailProbability = 1e-17;  // of the scale factor that the outer integral leaves out
constexpr int kPanels = 12;

/// Composite Gauss-Legendre rule, 20 points a panel.
template <class Function>
double integrate(const Function& f, double from, double to, int panels) {
  const double width = (to - from) / panels;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    sum += bm::quadrature::gauss<double, 20>::integrate(f, from + width * i, from + width * (i + 1));
  }
  return sum;
}

/// P(range of k standard normal values > w) = k integral phi(z) [Phi(z)^(k-1) - (Phi(z) - Phi(z - w))^(k-1)]
/// dz: the complement under the integral keeps small tails accurate.
double rangeUpper(double w, int groups) {
  if (w <= 0.0) {
    return 1.0;
  }
  const auto integrand = [&](double z) {
    const double upper = normalCdf(z);
    const double lower = normalCdf(z - w);
    // a^(k-1) - b^(k-1) = (a - b) sum a^i b^(k-2-i), with a - b = Phi(z - w)
    double sum = 0.0;
    const double inside = upper - lower;
    for (int i = 0; i <= groups - 2; ++i) {
      sum += std::pow(upper, i) * std::pow(inside, groups - 2 - i);
    }
    return normalDensity(z) * lower * sum;
  };
  constexpr double kReach = 8.5;
  constexpr int kInnerPanels = 10;
  return groups * integrate(integrand, -kReach, kReach, kInnerPanels);
}

}  // namespace

double normalDensity(double x) {
  return bm::pdf(Normal(), x);
}
double normalCdf(double x) {
  return bm::cdf(Normal(), x);
}
double normalUpper(double x) {
  return bm::cdf(bm::complement(Normal(), x));
}
double normalQuantile(double p) {
  TORSIO_EXPECTS(p > 0.0 && p < 1.0);
  return bm::quantile(Normal(), p);
}
double normalTwoSided(double z) {
  return 2.0 * normalUpper(std::abs(z));
}

double tQuantile(double p, double df) {
  TORSIO_EXPECTS(p > 0.0 && p < 1.0);
  return bm::quantile(StudentT(df), p);
}
double tTwoSided(double t, double df) {
  return 2.0 * bm::cdf(bm::complement(StudentT(df), std::abs(t)));
}

double fUpper(double f, double df1, double df2) {
  return bm::cdf(bm::complement(FisherF(df1, df2), f));
}
double fQuantile(double p, double df1, double df2) {
  return bm::quantile(FisherF(df1, df2), p);
}

double chiSquaredUpper(double x, double df) {
  return bm::cdf(bm::complement(ChiSquared(df), x));
}
double noncentralTCdf(double t, double df, double noncentrality) {
  return bm::cdf(NoncentralT(df, noncentrality), t);
}
double noncentralTUpper(double t, double df, double noncentrality) {
  return bm::cdf(bm::complement(NoncentralT(df, noncentrality), t));
}
double noncentralTQuantile(double p, double df, double noncentrality) {
  return bm::quantile(NoncentralT(df, noncentrality), p);
}
double noncentralFCdf(double f, double df1, double df2, double noncentrality) {
  return bm::cdf(NoncentralF(df1, df2, noncentrality), f);
}

double noncentralityOfT(double t, double df, double p) {
  TORSIO_EXPECTS(p > 0.0 && p < 1.0);
  // P(T <= t) falls as the noncentrality rises.
  const auto excess = [&](double d) { return noncentralTCdf(t, df, d) - p; };
  double low = t - 2.0;
  double high = t + 2.0;
  for (double step = 2.0; excess(low) < 0.0; step *= 1.5) {
    low -= step;
  }
  for (double step = 2.0; excess(high) > 0.0; step *= 1.5) {
    high += step;
  }
  std::uintmax_t iterations = 200;
  const auto [a, b] =
      bm::tools::toms748_solve(excess, low, high, bm::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (a + b);
}

double studentizedRangeUpper(double q, int groups, double df) {
  TORSIO_EXPECTS(groups >= 2 && df >= 1.0);
  if (q <= 0.0) {
    return 1.0;
  }
  constexpr double kAsGoodAsKnown = 1e6;  // the scale no longer matters in double precision
  if (df > kAsGoodAsKnown) {
    return rangeUpper(q, groups);
  }
  const double logScale = std::log(2.0) + 0.5 * df * std::log(0.5 * df) - std::lgamma(0.5 * df);
  const auto integrand = [&](double s) {
    const double logDensity = logScale + (df - 1.0) * std::log(s) - 0.5 * df * s * s;
    return std::exp(logDensity) * rangeUpper(q * s, groups);
  };
  const double from = std::sqrt(bm::quantile(ChiSquared(df), kTailProbability) / df);
  const double to = std::sqrt(bm::quantile(bm::complement(ChiSquared(df), kTailProbability)) / df);
  return integrate(integrand, from, to, kPanels);
}

double studentizedRangeQuantile(double p, int groups, double df) {
  TORSIO_EXPECTS(p > 0.0 && p < 1.0);
  const auto excess = [&](double q) { return studentizedRangeUpper(q, groups, df) - (1.0 - p); };
  double high = 4.0;
  while (excess(high) > 0.0) {
    high *= 2.0;
  }
  std::uintmax_t iterations = 100;
  const auto [a, b] =
      bm::tools::toms748_solve(excess, 1e-6, high, bm::tools::eps_tolerance<double>(44), iterations);
  return 0.5 * (a + b);
}

}  // namespace torsio
