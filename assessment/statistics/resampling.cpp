// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/resampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/random.h"

namespace torsio {

namespace {

constexpr double kMaxResamples = 1e6;

std::vector<double> drawAll(std::size_t n, const ResampledStatistic& statistic) {
  std::vector<double> out;
  std::vector<std::size_t> rows(n, 0);
  for (;;) {
    out.push_back(statistic(rows));
    std::size_t digit = 0;
    while (digit < n && ++rows[digit] == n) {
      rows[digit++] = 0;
    }
    if (digit == n) {
      return out;
    }
  }
}

std::vector<double> drawSome(std::size_t n, const ResampledStatistic& statistic,
                             const BootstrapOptions& options) {
  Random random(options.seed);
  std::vector<double> out;
  std::vector<std::size_t> rows(n, 0);
  for (std::int64_t b = 0; b < options.resamples; ++b) {
    for (std::size_t& row : rows) {
      row = random.bounded(n);
    }
    out.push_back(statistic(rows));
  }
  return out;
}

Interval atLevels(const std::vector<double>& values, double low, double high) {
  return {*quantile(values, low, QuantileRule::kType1), *quantile(values, high, QuantileRule::kType1)};
}

/// Tolerance for equality: sums of the same numbers in another order differ in the last bit.
double roundingAt(double value) {
  return 1e-12 * std::max(1.0, std::abs(value));
}

}  // namespace

Outcome<Jackknife> jackknife(std::size_t trainees, const ResampledStatistic& statistic) {
  if (trainees < 3) {
    return Outcome<Jackknife>::undefined(Text::tr("there are fewer than three trainees"));
  }
  std::vector<double> values;
  std::vector<std::size_t> rows(trainees - 1);
  std::iota(rows.begin(), rows.end(), std::size_t{1});
  for (std::size_t out = 0; out < trainees; ++out) {
    if (out > 0) {
      rows[out - 1] = out - 1;  // the one left out in the previous round
    }
    values.push_back(statistic(rows));
  }
  if (const std::optional<Text> reason = beyondArithmetic(values)) {
    return Outcome<Jackknife>::undefined(*reason);
  }
  const double mean = meanOf(values);
  double squares = 0.0;
  double cubes = 0.0;
  bool changes = false;
  for (const double value : values) {
    const double d = mean - value;
    squares += d * d;
    cubes += d * d * d;
    changes = changes || std::abs(d) > roundingAt(mean);
  }
  if (!changes) {
    return Jackknife{};
  }
  const double n = static_cast<double>(trainees);
  return Jackknife{std::sqrt((n - 1.0) / n * squares), cubes / (6.0 * std::pow(squares, 1.5))};
}

Outcome<Bootstrap> bootstrap(std::size_t trainees, const ResampledStatistic& statistic,
                             const BootstrapOptions& options) {
  const Outcome<Jackknife> leaveOut = jackknife(trainees, statistic);
  if (!leaveOut) {
    return Outcome<Bootstrap>::undefined(leaveOut.reason());
  }
  const double n = static_cast<double>(trainees);
  TORSIO_EXPECTS(!options.everyResample || std::pow(n, n) <= kMaxResamples);
  TORSIO_EXPECTS(options.resamples >= 1);
  const std::vector<double> values =
      options.everyResample ? drawAll(trainees, statistic) : drawSome(trainees, statistic, options);
  if (const std::optional<Text> reason = beyondArithmetic(values)) {
    return Outcome<Bootstrap>::undefined(*reason);
  }
  std::vector<std::size_t> rows(trainees);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  Bootstrap out;
  out.estimate = statistic(rows);
  out.resamples = std::ssize(values);
  const double count = static_cast<double>(values.size());
  out.error = std::sqrt(sumOfSquares(values) / count);
  const double rounding = roundingAt(out.estimate);
  double below = 0.0;
  bool changes = false;
  for (const double value : values) {
    changes = changes || std::abs(value - out.estimate) > rounding;
    if (value < out.estimate - rounding) {
      below += 1.0;
    } else if (value <= out.estimate + rounding) {
      below += 0.5;
    }
  }
  if (!changes) {
    return Outcome<Bootstrap>::undefined(Text::tr("the statistic does not change with any trainee"));
  }
  if (below == 0.0 || below == count) {
    return Outcome<Bootstrap>::undefined(Text::tr("every resample lies on the same side of the estimate"));
  }
  const double tail = 0.5 * (1.0 - options.confidence);
  out.percentile = atLevels(values, tail, 1.0 - tail);
  out.basic = {2.0 * out.estimate - out.percentile.upper, 2.0 * out.estimate - out.percentile.lower};
  out.z0 = normalQuantile(below / count);
  out.acceleration = leaveOut->acceleration;
  const auto level = [&](double z) {
    const double shifted = out.z0 + z;
    return normalCdf(out.z0 + shifted / (1.0 - out.acceleration * shifted));
  };
  out.bcaLevels = {level(normalQuantile(tail)), level(normalQuantile(1.0 - tail))};
  out.bca = atLevels(values, out.bcaLevels.lower, out.bcaLevels.upper);
  return out;
}

Outcome<Correlation> pearson(std::span<const double> x, std::span<const double> y, double confidence) {
  TORSIO_EXPECTS(x.size() == y.size());
  if (const std::optional<Text> reason = beyondArithmetic(x, y)) {
    return Outcome<Correlation>::undefined(*reason);
  }
  if (x.size() < 2) {
    return Outcome<Correlation>::undefined(Text::tr("there are fewer than two pairs"));
  }
  const double meanX = meanOf(x);
  const double meanY = meanOf(y);
  const double scale = std::sqrt(sumOfSquares(x) * sumOfSquares(y));
  if (scale == 0.0) {
    return Outcome<Correlation>::undefined(Text::tr("one of the two does not vary"));
  }
  double product = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    product += (x[i] - meanX) * (y[i] - meanY);
  }
  Correlation out;
  out.r = std::clamp(product / scale, -1.0, 1.0);
  if (x.size() > 3 && std::abs(out.r) < 1.0) {
    const double reach =
        normalQuantile(0.5 * (1.0 + confidence)) / std::sqrt(static_cast<double>(x.size()) - 3.0);
    const double z = std::atanh(out.r);
    out.fisherInterval = Interval{std::tanh(z - reach), std::tanh(z + reach)};
  }
  return out;
}

}  // namespace torsio
