// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "assessment/statistics/values.h"

namespace torsio {

/// Difference of two groups' adjusted means, with its t test and intervals.
struct AdjustedDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0.0;  ///< adjusted mean of the first minus that of the second
  double error = 0.0;
  double df = 0.0;
  double t = 0.0;
  double p = 0.0;
  double pHolm = 0.0;
  Interval interval;      ///< not adjusted for the number of pairs
  Interval asHolm;        ///< excludes 0 exactly if pHolm < 1 - confidence (holmFactors())
  Interval simultaneous;  ///< Bonferroni over the pairs
};

/// Returns a difference with its t test; addIntervals() fills the rest.
[[nodiscard]] AdjustedDifference adjustedDifference(std::size_t first, std::size_t second, double difference,
                                                    double error, double df);

/// Fills the intervals and pHolm of `pairs`, which are all that are compared.
void addIntervals(std::span<AdjustedDifference> pairs, double confidence);

}  // namespace torsio
