// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr double kFuzz = 4.0 * std::numeric_limits<double>::epsilon();  // n p that is whole up to rounding

std::vector<double> sorted(std::span<const double> values) {
  std::vector<double> out(values.begin(), values.end());
  std::sort(out.begin(), out.end());
  return out;
}

/// x[j] counted from 1, clamped to the ends.
double at(const std::vector<double>& x, double j) {
  const double n = static_cast<double>(x.size());
  return x[static_cast<std::size_t>(std::clamp(j, 1.0, n)) - 1];
}

double stepQuantile(const std::vector<double>& x, double p, QuantileRule rule) {
  const double n = static_cast<double>(x.size());
  const double position = rule == QuantileRule::kType3 ? n * p - 0.5 : n * p;
  const double j = std::floor(position + kFuzz);
  double h = 0.0;
  if (rule == QuantileRule::kType1) {
    h = position > j + kFuzz ? 1.0 : 0.0;
  }
  if (rule == QuantileRule::kType2) {
    h = position > j + kFuzz ? 1.0 : 0.5;
  }
  if (rule == QuantileRule::kType3) {
    h = (std::abs(position - j) > kFuzz || std::fmod(std::abs(j), 2.0) == 1.0) ? 1.0 : 0.0;
  }
  if (h == 0.0) {
    return at(x, j);
  }
  if (h == 1.0) {
    return at(x, j + 1.0);
  }
  return 0.5 * (at(x, j) + at(x, j + 1.0));
}

double plottingPosition(double n, double p, QuantileRule rule) {
  double a = 0.0;
  double b = 0.0;
  switch (rule) {
    case QuantileRule::kType4:
      a = 0.0;
      b = 1.0;
      break;
    case QuantileRule::kType5:
      a = b = 0.5;
      break;
    case QuantileRule::kType6:
      a = b = 0.0;
      break;
    case QuantileRule::kType8:
      a = b = 1.0 / 3.0;
      break;
    case QuantileRule::kType9:
      a = b = 3.0 / 8.0;
      break;
    default:
      a = b = 1.0;
      break;
  }
  return a + p * (n + 1.0 - a - b);
}

double quantileOfSorted(const std::vector<double>& x, double p, QuantileRule rule) {
  if (rule == QuantileRule::kType1 || rule == QuantileRule::kType2 || rule == QuantileRule::kType3) {
    return stepQuantile(x, p, rule);
  }
  const double position = plottingPosition(static_cast<double>(x.size()), p, rule);
  const double j = std::floor(position + kFuzz);
  double h = position - j;
  if (std::abs(h) < kFuzz) {
    h = 0.0;
  }
  const double low = at(x, j);
  const double high = at(x, j + 1.0);
  return h == 0.0 ? low : low + h * (high - low);
}

}  // namespace

std::optional<double> quantile(std::span<const double> values, double p, QuantileRule rule) {
  TORSIO_EXPECTS(p >= 0.0 && p <= 1.0);
  if (values.empty()) {
    return std::nullopt;
  }
  return quantileOfSorted(sorted(values), p, rule);
}

std::optional<BoxNumbers> boxNumbers(std::span<const double> values, QuantileRule rule) {
  if (values.empty()) {
    return std::nullopt;
  }
  const std::vector<double> x = sorted(values);
  BoxNumbers box;
  box.n = std::ssize(x);
  box.min = x.front();
  box.max = x.back();
  box.q1 = quantileOfSorted(x, 0.25, rule);
  box.median = quantileOfSorted(x, 0.5, rule);
  box.q3 = quantileOfSorted(x, 0.75, rule);
  const double reach = 1.5 * (box.q3 - box.q1);
  double sum = 0.0;
  bool inside = false;
  for (const double value : x) {
    sum += value;
    if (value < box.q1 - reach || value > box.q3 + reach) {
      box.outliers.push_back(value);
      continue;
    }
    if (!inside) {
      box.whiskerLow = value;
    }
    inside = true;
    box.whiskerHigh = value;
  }
  box.mean = sum / static_cast<double>(x.size());
  return box;
}

}  // namespace torsio
