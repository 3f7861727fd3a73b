// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "assessment/statistics/adjusted_difference.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/values.h"

namespace torsio {

struct AdjustedMean {
  double mean = 0.0;  ///< at the grand mean of the covariate
  double error = 0.0;
  Interval interval;
};

/// The comparison of groups whose residuals spread unequally.
struct UnequalSpread {
  double largest = 0.0;   ///< standard deviation of a group's residuals
  double smallest = 0.0;  ///< of another group's; 0: they do not spread at all
  Outcome<FTest> test = Outcome<FTest>::undefined(Text::tr("not computed"));  ///< Brown and Forsythe
  /// The same differences with the errors of HC3 (MacKinnon and White 1985) and the degrees of freedom of
  /// Bell and McCaffrey (2002), in the order of Ancova::pairs; empty if a trainee fits exactly, being alone
  /// in a group.
  std::vector<AdjustedDifference> pairs;
};
/// If the test of equal spread gives p below this, the report says so. The errors of HC3 are used in any
/// case: a test first would keep the pooled ones in small groups, where they cover too little.
inline constexpr double kSpreadsDiffer = 0.05;

/// Analysis of covariance: score after on score before and group, with a common slope. The primary analysis
/// of randomised groups scored before and after training.
struct Ancova {
  double slope = 0.0;
  double slopeError = 0.0;
  FTest group;
  double residualVariance = 0.0;
  double residualDf = 0.0;
  std::vector<std::size_t> groups;  ///< indices of the groups with scores, ascending; the others are left out
  std::vector<AdjustedMean> adjusted;     ///< of `groups`
  std::vector<AdjustedDifference> pairs;  ///< (0,1), (0,2), ..., (1,2) of `groups`, by index among all groups
  Outcome<FTest> equalSlopes = Outcome<FTest>::undefined(Text::tr("not computed"));
  UnequalSpread spread;
  double partialEtaSquared = 0.0;
  Groups fitted;     ///< fitted score of each trainee
  Groups residuals;  ///< score after minus fitted
  Groups quantiles;  ///< normal quantile of each residual at (rank - 0.5) / n
};

/// Compares groups by analysis of covariance. `before[g][i]` and `after[g][i]` belong to the same trainee and
/// are means over raters, never single marks. Empty groups are left out. Undefined for fewer than two groups
/// with scores, too few trainees, or no variation within groups before or after.
[[nodiscard]] Outcome<Ancova> ancova(const Groups& before, const Groups& after,
                                     double confidence = kDefaultConfidence);

/// Returns the differences from which conclusions are drawn: with the errors of HC3, or the pooled ones where
/// HC3 has none.
[[nodiscard]] inline const std::vector<AdjustedDifference>& concludedPairs(const Ancova& of) noexcept {
  return of.spread.pairs.empty() ? of.pairs : of.spread.pairs;
}

/// If the test of equal slopes gives p below this, the analysis with separate slopes is reported as well.
inline constexpr double kSlopesDiffer = 0.05;

/// Range of scores before in which two groups differ (Johnson and Neyman 1936), at the confidence of the
/// analysis, not adjusted for the number of pairs.
struct SignificantRegion {
  std::optional<Interval> inside;   ///< they differ between these scores
  std::optional<Interval> outside;  ///< they differ below the lower and above the upper score
  bool everywhere = false;          ///< they differ at any score. None of the three: nowhere
};

/// Comparison of two groups at given scores before.
struct SlopesPair {
  std::size_t first = 0;
  std::size_t second = 0;
  std::vector<AdjustedDifference> at;  ///< in the order of SeparateSlopes::baselines; pHolm over all of these
  SignificantRegion region;
};

/// Analysis of covariance with one slope per group: the difference depends on the score before.
struct SeparateSlopes {
  std::vector<std::size_t> groups;  ///< indices of the groups with scores, ascending
  std::vector<double> slopes;       ///< of `groups`
  std::vector<double> slopeErrors;
  double residualVariance = 0.0;
  double residualDf = 0.0;
  std::vector<double> baselines;
  std::vector<SlopesPair> pairs;
};

/// Compares groups at each of `baselines`, with separate slopes and one residual variance. Undefined like
/// ancova(), and if the scores before do not vary in a group.
[[nodiscard]] Outcome<SeparateSlopes> separateSlopes(const Groups& before, const Groups& after,
                                                     std::span<const double> baselines,
                                                     double confidence = kDefaultConfidence);

/// Returns the mean of all scores before, and one standard deviation below and above it, ascending. Requires
/// at least two scores.
[[nodiscard]] std::vector<double> defaultBaselines(const Groups& before);

/// Two one-sided tests (Schuirmann 1987) that a difference lies within a margin around 0.
struct Equivalence {
  double margin = 0.0;
  double pBelow = 0.0;  ///< for a difference of -margin or less
  double pAbove = 0.0;  ///< for a difference of margin or more
  double p = 0.0;       ///< the larger of the two; small: the difference lies within the margin
  Interval interval;    ///< with confidence 1 - 2 alpha; inside the margin exactly if p < alpha
};
/// Tests a difference given its standard error and degrees of freedom; `margin` and `error` > 0.
[[nodiscard]] Equivalence equivalence(double difference, double error, double df, double margin,
                                      double alpha = 1.0 - kDefaultConfidence);

}  // namespace torsio
