// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/distributions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

namespace bm = boost::math;

// No promotion to long double: its width differs between platforms.
using Policy = bm::policies::policy<bm::policies::promote_double<false>, bm::policies::promote_float<false>>;
using Normal = bm::normal_distribution<double, Policy>;
using StudentT = bm::students_t_distribution<double, Policy>;
using FisherF = bm::fisher_f_distribution<double, Policy>;
using ChiSquared = bm::chi_squared_distribution<double, Policy>;
using NoncentralT = bm::non_central_t_distribution<double, Policy>;
using NoncentralF = bm::non_central_f_distribution<double, Policy>;

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
/// dz: the complement under the integral keeps small tails accurate, and a^n - b^n = -a^n expm1(n log1p(b/a -
/// 1)).
double rangeUpper(double w, int groups) {
  if (w <= 0.0) {
    return 1.0;
  }
  const double n = groups - 1;
  const auto integrand = [&](double z) {
    const double upper = normalCdf(z);
    const double lower = normalCdf(z - w);
    if (lower >= upper) {
      return normalDensity(z) * std::pow(upper, n);
    }
    return -normalDensity(z) * std::pow(upper, n) * std::expm1(n * std::log1p(-lower / upper));
  };
  constexpr double kReach = 8.5;
  constexpr double kPanelWidth = 1.7;
  const double to = kReach + 0.5 * w;  // a wide range has its largest value about w / 2
  return groups * integrate(integrand, -kReach, to, static_cast<int>(std::ceil((to + kReach) / kPanelWidth)));
}

constexpr double kPanelWidth = 0.5;    // of the interpolation, in standard deviations
constexpr double kWidestRange = 50.0;  // beyond, the upper tail is below 1e-270

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
double chiSquaredQuantile(double p, double df) {
  return bm::quantile(ChiSquared(df), p);
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
  constexpr double kFar = 5e3;  // beyond, the series of the noncentral distribution loses digits, then ends
  if (t < -kFar) {
    return -noncentralityOfT(-t, df, 1.0 - p);
  }
  if (t > kFar) {
    // T = (Z + d) / U <= t where the scale U >= (d + Z) / t. With f the density of U, F(d/t) + f'(d/t) / (2
    // t^2) = 1 - p up to terms of t^-4.
    const double u = std::sqrt(bm::quantile(bm::complement(ChiSquared(df), p)) / df);
    return t * u - ((df - 1.0) / u - df * u) / (2.0 * t);
  }
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

StudentizedRange::StudentizedRange(int groups)
    : groups_(groups), panels_(static_cast<std::size_t>(kWidestRange / kPanelWidth)) {
  TORSIO_EXPECTS(groups >= 2);
}

const std::array<double, StudentizedRange::kTerms>& StudentizedRange::panel(std::size_t number) {
  std::optional<std::array<double, kTerms>>& terms = panels_[number];
  if (!terms) {
    terms.emplace();
    constexpr double kCount = kTerms;
    for (std::size_t i = 0; i < kTerms; ++i) {
      const double angle = std::numbers::pi * (static_cast<double>(i) + 0.5) / kCount;
      const double w = kPanelWidth * (static_cast<double>(number) + 0.5 + 0.5 * std::cos(angle));
      const double value = std::log(rangeUpper(w, groups_));
      for (std::size_t j = 0; j < kTerms; ++j) {
        (*terms)[j] += (j == 0 ? 1.0 : 2.0) / kCount * value * std::cos(static_cast<double>(j) * angle);
      }
    }
  }
  return *terms;
}

double StudentizedRange::logRangeUpper(double w) {
  const double place = w / kPanelWidth;
  const auto number = static_cast<std::size_t>(place);
  const std::array<double, kTerms>& terms = panel(number);
  const double x = 2.0 * (place - static_cast<double>(number)) - 1.0;
  double sum = 0.0;  // Clenshaw
  double before = 0.0;
  for (std::size_t j = kTerms - 1; j > 0; --j) {
    before = std::exchange(sum, terms[j] + 2.0 * x * sum - before);
  }
  return terms[0] + x * sum - before;
}

double StudentizedRange::upper(double q, double df) {
  TORSIO_EXPECTS(df >= 1.0);
  if (q <= 0.0) {
    return 1.0;
  }
  const auto tail = [&](double w) { return w < kWidestRange ? std::exp(logRangeUpper(w)) : 0.0; };
  constexpr double kAsGoodAsKnown = 1e6;  // the scale no longer matters in double precision
  if (df > kAsGoodAsKnown) {
    return tail(q);
  }
  // Over u = log s of the scale s, where the density is smooth for every df: that of s is 2 (df/2)^(df/2) /
  // Gamma(df/2) s^(df-1) exp(-df s^2/2).
  const double logScale = std::log(2.0) + 0.5 * df * std::log(0.5 * df) - std::lgamma(0.5 * df);
  const auto integrand = [&](double u) {
    const double s = std::exp(u);
    return std::exp(logScale + df * u - 0.5 * df * s * s) * tail(q * s);
  };
  constexpr double kTailProbability = 1e-17;  // of the scale that the outer integral leaves out
  const double from = 0.5 * std::log(bm::quantile(ChiSquared(df), kTailProbability) / df);
  const double to = 0.5 * std::log(bm::quantile(bm::complement(ChiSquared(df), kTailProbability)) / df);
  // The tail falls from 1 to 0 within a few tenths of u where there are many groups; below it is smooth.
  constexpr double kSmooth = 0.5;
  constexpr double kWidePanel = 2.5;
  constexpr double kNarrowPanel = 0.5;
  const double middle = std::clamp(std::log(kSmooth / q), from, to);
  const double end = std::clamp(std::log(kWidestRange / q), middle, to);
  const auto panels = [](double width, double widest) {
    constexpr double kMinPanels = 8.0;
    return static_cast<int>(std::max(kMinPanels, std::ceil(width / widest)));
  };
  return integrate(integrand, from, middle, panels(middle - from, kWidePanel)) +
         integrate(integrand, middle, end, panels(end - middle, kNarrowPanel));
}

double StudentizedRange::quantile(double p, double df) {
  TORSIO_EXPECTS(p > 0.0 && p < 1.0);
  const auto excess = [&](double q) { return upper(q, df) - (1.0 - p); };
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
