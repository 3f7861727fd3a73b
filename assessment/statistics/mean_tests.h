// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

using Groups = std::vector<std::vector<double>>;  ///< one list of values per group

/// The nonempty groups, which are compared; pairs name groups by their index among all.
struct PresentGroups {
  Groups values;
  std::vector<std::size_t> numbers;  ///< indices among all groups, ascending
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
/// fewer than two values in a group or no variation.
[[nodiscard]] Outcome<TTest> welchT(std::span<const double> x, std::span<const double> y,
                                    double confidence = kDefaultConfidence);
/// Compares two means with pooled variance by Student's t test. Undefined like welchT.
[[nodiscard]] Outcome<TTest> studentT(std::span<const double> x, std::span<const double> y,
                                      double confidence = kDefaultConfidence);
/// Compares paired values by the t test of their differences. Undefined for fewer than two pairs or
/// differences that do not vary.
[[nodiscard]] Outcome<TTest> pairedT(std::span<const double> x, std::span<const double> y,
                                     double confidence = kDefaultConfidence);

/// Estimates the weighted mean of strata that vary independently, and tests it against 0: `difference` is
/// that mean, its error sums the squares of share x standard error, degrees of freedom after Welch and
/// Satterthwaite. `weights`: one per stratum; strata of weight 0 do not count. Undefined if a weighted
/// stratum has fewer than two values, or none of them varies.
[[nodiscard]] Outcome<TTest> stratifiedMean(const Groups& strata, std::span<const double> weights,
                                            double confidence = kDefaultConfidence);

/// Returns Student's t interval of a mean; empty for fewer than two values. The squares must not overflow.
[[nodiscard]] std::optional<Interval> meanInterval(std::span<const double> values,
                                                   double confidence = kDefaultConfidence);

/// Mean difference standardised by the pooled standard deviation, with small-sample correction.
struct HedgesG {
  double d = 0.0;
  double correction = 0.0;  ///< J, exact
  double g = 0.0;
  Interval noncentrality;
  Interval dInterval;
  Interval interval;        ///< of g, from the noncentral t distribution
  double error = 0.0;       ///< large-sample standard error of g
  Interval normalInterval;  ///< for comparison with programs that report it
};
/// Computes Hedges' g of two groups, first minus second. Undefined like welchT.
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
/// Compares means with equal variances by one-way analysis of variance. Here and below, empty groups are left
/// out. Undefined for fewer than two groups with values, or no variation within groups.
[[nodiscard]] Outcome<OneWayAnova> oneWayAnova(const Groups& groups);

struct FTest {
  double f = 0.0;
  double df1 = 0.0;
  double df2 = 0.0;
  double p = 0.0;
};
/// Compares means with unequal variances by Welch's analysis of variance (the default for three or more
/// groups). Undefined if a group does not vary.
[[nodiscard]] Outcome<FTest> welchAnova(const Groups& groups);
/// Tests equality of spread by analysis of variance of the distances from the group medians.
[[nodiscard]] Outcome<FTest> brownForsythe(const Groups& groups);

struct ChiSquaredTest {
  double statistic = 0.0;
  double df = 0.0;
  double p = 0.0;
};
/// Tests equality of variances of normal groups; do not use it to choose another test.
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
/// Compares all pairs with unequal variances (Games-Howell); follows Welch's analysis of variance.
[[nodiscard]] Outcome<std::vector<PairComparison>> gamesHowellPairs(const Groups& groups,
                                                                    double confidence = kDefaultConfidence);

}  // namespace torsio
