// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

using Groups = std::vector<std::vector<double>>;  ///< one list of values a group

/// The groups that have values. Comparisons are made of these; pairs name groups by their number in all.
struct PresentGroups {
  Groups values;
  std::vector<std::size_t> numbers;  ///< in all groups, ascending
};
[[nodiscard]] PresentGroups presentGroups(const Groups& groups);

struct TTest {
  double difference = 0.0;  ///< first minus second
  double error = 0.0;
  double t = 0.0;
  double df = 0.0;
  double p = 0.0;  ///< two-sided
  Interval interval;
};

/// Compares two means with unequal variances by Welch's t test (the default for two groups). Undefined for
/// fewer than two values a group or no variation.
[[nodiscard]] Outcome<TTest> welchT(std::span<const double> x, std::span<const double> y,
                                    double confidence = kDefaultConfidence);
/// Compares two means with pooled variance by Student's t test. Undefined as welchT.
[[nodiscard]] Outcome<TTest> studentT(std::span<const double> x, std::span<const double> y,
                                      double confidence = kDefaultConfidence);
/// Compares paired values by the t test of their differences. Undefined for fewer than two pairs or
/// differences that do not vary.
[[nodiscard]] Outcome<TTest> pairedT(std::span<const double> x, std::span<const double> y,
                                     double confidence = kDefaultConfidence);

/// Returns the interval of one mean by Student's t; empty for fewer than two values. The values can be
/// squared.
[[nodiscard]] std::optional<Interval> meanInterval(std::span<const double> values,
                                                   double confidence = kDefaultConfidence);

/// Standardised difference with the pooled standard deviation, corrected for small groups.
struct HedgesG {
  double d = 0.0;
  double correction = 0.0;  ///< J, exact
  double g = 0.0;
  Interval noncentrality;
  Interval dInterval;
  Interval interval;        ///< of g, from the noncentral t distribution
  double error = 0.0;       ///< large-sample standard error of g
  Interval normalInterval;  ///< for comparison with programs that use it
};
/// Computes Hedges' g of two groups, first minus second. Undefined as welchT.
[[nodiscard]] Outcome<HedgesG> hedgesG(std::span<const double> x, std::span<const double> y,
                                       double confidence = kDefaultConfidence);

struct OneWayAnova {
  double ssBetween = 0.0;
  double ssWithin = 0.0;
  double df1 = 0.0;
  double df2 = 0.0;
  double msBetween = 0.0;
  double msWithin = 0.0;
  double f = 0.0;
  double p = 0.0;
  double etaSquared = 0.0;
  double omegaSquared = 0.0;
  double epsilonSquared = 0.0;
};
/// Compares means with equal variances by analysis of variance; empty groups are left out, here and below.
/// Undefined for fewer than two groups with values, or no variation within groups.
[[nodiscard]] Outcome<OneWayAnova> oneWayAnova(const Groups& groups);

struct FTest {
  double f = 0.0;
  double df1 = 0.0;
  double df2 = 0.0;
  double p = 0.0;
};
/// Compares means with unequal variances by Welch's analysis of variance (the default for three groups).
/// Undefined when a group does not vary.
[[nodiscard]] Outcome<FTest> welchAnova(const Groups& groups);
/// Tests equality of spread: analysis of variance of distances from the group medians.
[[nodiscard]] Outcome<FTest> brownForsythe(const Groups& groups);

struct ChiSquaredTest {
  double statistic = 0.0;
  double df = 0.0;
  double p = 0.0;
};
/// Tests equality of variances of normal groups; not for choosing another test.
[[nodiscard]] Outcome<ChiSquaredTest> bartlett(const Groups& groups);

struct PairComparison {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0.0;  ///< mean of second minus mean of first
  double q = 0.0;           ///< studentised range statistic, absolute
  double df = 0.0;
  double p = 0.0;  ///< adjusted for all pairs
  Interval interval;
};
/// Compares all pairs with equal variances (Tukey-Kramer), ordered (0,1), (0,2), ..., (1,2).
[[nodiscard]] Outcome<std::vector<PairComparison>> tukeyPairs(const Groups& groups,
                                                              double confidence = kDefaultConfidence);
/// Compares all pairs with unequal variances; follows Welch's analysis of variance.
[[nodiscard]] Outcome<std::vector<PairComparison>> gamesHowellPairs(const Groups& groups,
                                                                    double confidence = kDefaultConfidence);

}  // namespace torsio
