// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// Order statistics of all pairs of values without listing the pairs. Private to assessment/statistics.
namespace torsio {

/// Bisects the doubles from low to high for the smallest x with atOrBelow(x) > rank.
template <class Count>
[[nodiscard]] double smallestAbove(double low, double high, std::int64_t rank, const Count& atOrBelow) {
  if (atOrBelow(low) > rank) {
    return low;
  }
  for (;;) {  // atOrBelow(low) <= rank < atOrBelow(high)
    const double middle = 0.5 * low + 0.5 * high;
    if (middle <= low || middle >= high) {
      return high;
    }
    (atOrBelow(middle) > rank ? high : low) = middle;
  }
}

/// Median of `count` values given by their order statistics.
template <class At>
[[nodiscard]] double medianBy(std::int64_t count, const At& at) {
  const double upper = at(count / 2);
  return count % 2 == 1 ? upper : 0.5 * (at(count / 2 - 1) + upper);
}

[[nodiscard]] inline std::vector<double> sorted(std::span<const double> values) {
  std::vector<double> out(values.begin(), values.end());
  std::sort(out.begin(), out.end());
  return out;
}

/// All differences x - y in order, without listing them. Both inputs ascend.
class PairDifferences {
 public:
  PairDifferences(std::span<const double> x, std::span<const double> y) : x_(sorted(x)), y_(sorted(y)) {}

  [[nodiscard]] double at(std::int64_t rank) const {
    return smallestAbove(x_.front() - y_.back(), x_.back() - y_.front(), rank,
                         [this](double limit) { return atOrBelow(limit); });
  }
  [[nodiscard]] std::int64_t count() const { return std::ssize(x_) * std::ssize(y_); }

 private:
  [[nodiscard]] std::int64_t atOrBelow(double limit) const {
    std::int64_t count = 0;
    std::size_t j = 0;  // first y at which the difference is at or below
    for (const double a : x_) {
      while (j < y_.size() && a - y_[j] > limit) {
        ++j;
      }
      count += static_cast<std::int64_t>(y_.size() - j);
    }
    return count;
  }

  std::vector<double> x_;
  std::vector<double> y_;
};

/// Median of all pairwise means, including each value with itself.
[[nodiscard]] inline double medianOfPairMeans(std::span<const double> of) {
  const std::vector<double> values = sorted(of);
  const auto atOrBelow = [&](double limit) {
    std::int64_t count = 0;
    std::size_t j = values.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      while (j > i && 0.5 * (values[i] + values[j - 1]) > limit) {
        --j;
      }
      if (j <= i) {
        break;
      }
      count += static_cast<std::int64_t>(j - i);
    }
    return count;
  };
  return medianBy(std::ssize(values) * (std::ssize(values) + 1) / 2, [&](std::int64_t rank) {
    return smallestAbove(values.front(), values.back(), rank, atOrBelow);
  });
}

}  // namespace torsio
