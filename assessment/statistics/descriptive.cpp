// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/descriptive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sim/core/contracts.h"

namespace torsio {

double meanOf(std::span<const double> values) {
  TORSIO_EXPECTS(!values.empty());
  // Neumaier's compensated sum.
  double sum = 0.0;
  double correction = 0.0;
  for (const double x : values) {
    const double next = sum + x;
    correction += std::abs(sum) >= std::abs(x) ? (sum - next) + x : (x - next) + sum;
    sum = next;
  }
  return (sum + correction) / static_cast<double>(values.size());
}

double sumOfSquares(std::span<const double> values) {
  const double mean = meanOf(values);
  double squares = 0.0;
  double deviations = 0.0;
  for (const double x : values) {
    const double d = x - mean;
    squares += d * d;
    deviations += d;
  }
  return squares - deviations * deviations / static_cast<double>(values.size());
}

double roundingSquares(std::span<const double> values) {
  double squares = 0.0;
  for (const double x : values) {
    const double rounding = 2.0 * std::numeric_limits<double>::epsilon() * x;
    squares += rounding * rounding;
  }
  return squares;
}

double squaresBeyondRounding(std::span<const double> values) {
  const double squares = sumOfSquares(values);
  return squares <= roundingSquares(values) ? 0.0 : squares;
}

std::optional<double> sampleVariance(std::span<const double> values) {
  if (values.size() < 2) {
    return std::nullopt;
  }
  return sumOfSquares(values) / static_cast<double>(values.size() - 1);
}

std::optional<double> sampleDeviation(std::span<const double> values) {
  const std::optional<double> variance = sampleVariance(values);
  if (!variance) {
    return std::nullopt;
  }
  return std::sqrt(*variance);
}

namespace {

constexpr double kLargest = 1e70;
constexpr double kSmallestSpread = 1e-70;

/// Largest magnitude and range of values.
struct Extent {
  double largest = 0.0;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

void extend(Extent& extent, std::span<const double> values) {
  for (const double value : values) {
    extent.largest = std::isfinite(value) ? std::max(extent.largest, std::abs(value))
                                          : std::numeric_limits<double>::infinity();
    extent.lowest = std::min(extent.lowest, value);
    extent.highest = std::max(extent.highest, value);
  }
}

std::optional<Text> reasonOf(const Extent& extent) {
  if (!(extent.largest <= kLargest)) {
    return Text::tr("the values are too large to be squared");
  }
  const double spread = extent.highest - extent.lowest;
  if (spread > 0.0 && spread < kSmallestSpread) {
    return Text::tr("the values lie too close together to be squared");
  }
  return std::nullopt;
}

}  // namespace

std::optional<Text> beyondArithmetic(std::span<const double> values) {
  Extent extent;
  extend(extent, values);
  return reasonOf(extent);
}

std::optional<Text> beyondArithmetic(std::span<const double> x, std::span<const double> y) {
  Extent extent;
  extend(extent, x);
  extend(extent, y);
  return reasonOf(extent);
}

std::optional<Text> beyondArithmetic(const std::vector<std::vector<double>>& groups) {
  Extent extent;
  for (const std::vector<double>& group : groups) {
    extend(extent, group);
  }
  return reasonOf(extent);
}

double medianOf(std::span<const double> values) {
  TORSIO_EXPECTS(!values.empty());
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

DoubledRanks doubledRanks(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  DoubledRanks out;
  out.ranks.resize(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first;
    while (end < order.size() && !(values[order[first]] < values[order[end]])) {
      ++end;
    }
    const auto ties = static_cast<std::int64_t>(end - first);
    out.tieTerm += ties * ties * ties - ties;
    // Ranks first + 1 .. end have the middle (first + 1 + end) / 2.
    for (std::size_t i = first; i < end; ++i) {
      out.ranks[order[i]] = static_cast<std::int64_t>(first + 1 + end);
    }
    first = end;
  }
  return out;
}

namespace {

/// Returns values times `scale`, if all of them are whole.
std::optional<std::vector<std::int64_t>> wholeAt(std::span<const double> values, double scale) {
  constexpr double kExactBelow = 9e15;  // every whole double
  constexpr double kRounding = 9e-16;   // of a decimal or a mean to its double, and of the product
  std::vector<std::int64_t> whole;
  for (const double x : values) {
    const double scaled = x * scale;
    const double nearest = std::round(scaled);
    if (std::abs(scaled) > kExactBelow || std::abs(scaled - nearest) > kRounding * std::abs(scaled)) {
      return std::nullopt;
    }
    whole.push_back(static_cast<std::int64_t>(nearest));
  }
  return whole;
}

}  // namespace

std::optional<std::vector<std::int64_t>> asWholeNumbers(std::span<const double> values) {
  constexpr int kMaxMarks = 60;
  for (int marks = 1; marks <= kMaxMarks; ++marks) {
    for (double scale = 1.0; scale <= 1e6; scale *= 10.0) {
      if (auto whole = wholeAt(values, marks * scale)) {
        return whole;
      }
    }
  }
  return std::nullopt;
}

}  // namespace torsio
