// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/values.h"

namespace torsio {

struct AdjustedMean {
  double mean = 0.0;  ///< at the grand mean of the covariate
  double error = 0.0;
  Interval interval;
};

struct AdjustedDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0.0;  ///< adjusted mean of first minus that of second
  double error = 0.0;
  double t = 0.0;
  double p = 0.0;
  double pHolm = 0.0;
  Interval interval;      ///< not adjusted for the number of pairs
  Interval simultaneous;  ///< Bonferroni over the pairs: all hold together with the confidence or more
};

/// Analysis of covariance: score after on score before and group, one pooled slope. The primary analysis of
/// randomised groups with a score before and after training.
struct Ancova {
  double slope = 0.0;
  double slopeError = 0.0;
  FTest group;
  double residualVariance = 0.0;
  double residualDf = 0.0;
  std::vector<std::size_t> groups;     ///< numbers of those with scores, ascending; the others are left out
  std::vector<AdjustedMean> adjusted;  ///< of `groups`
  std::vector<AdjustedDifference> pairs;  ///< (0,1), (0,2), ..., (1,2) of `groups`, by their number in all
  Outcome<FTest> equalSlopes = Outcome<FTest>::undefined(Text::tr("not computed"));
  double partialEtaSquared = 0.0;
  Groups fitted;     ///< what the model says for each trainee
  Groups residuals;  ///< score after minus fitted
  Groups quantiles;  ///< what a normal distribution of that spread has at (rank - 0.5) / n of each residual
};

/// Compares groups by analysis of covariance. `before[g][i]` and `after[g][i]` belong to the same trainee;
/// means over raters, never single marks. Empty groups are left out. Undefined for fewer than two groups with
/// scores, too few trainees, or when the scores before, or those after, do not vary within groups.
[[nodiscard]] Outcome<Ancova> ancova(const Groups& before, const Groups& after,
                                     double confidence = kDefaultConfidence);

/// Level of the test of equal slopes below which the analysis with separate slopes is made as well.
inline constexpr double kSlopesDiffer = 0.05;

/// Where on the scale of the scores before two groups differ (Johnson and Neyman 1936), at the confidence of
/// the analysis, not adjusted for the number of pairs.
struct SignificantRegion {
  std::optional<Interval> inside;   ///< they differ between these scores
  std::optional<Interval> outside;  ///< they differ below the lower and above the upper one
  bool everywhere = false;          ///< at any score; none of the three: nowhere
};

/// Two groups at stated scores before.
struct SlopesPair {
  std::size_t first = 0;
  std::size_t second = 0;
  std::vector<AdjustedDifference> at;  ///< in the order of SeparateSlopes::baselines; pHolm over all of these
  SignificantRegion region;
};

/// Analysis of covariance with a slope for each group: what a difference is then depends on the score before.
struct SeparateSlopes {
  std::vector<std::size_t> groups;  ///< numbers of those with scores, ascending
  std::vector<double> slopes;       ///< of `groups`
  std::vector<double> slopeErrors;
  double residualVariance = 0.0;
  double residualDf = 0.0;
  std::vector<double> baselines;
  std::vector<SlopesPair> pairs;
};

/// Compares groups at each of `baselines`, with separate slopes and one residual variance. Undefined as
/// ancova(), and when the scores before do not vary in one group.
[[nodiscard]] Outcome<SeparateSlopes> separateSlopes(const Groups& before, const Groups& after,
                                                     std::span<const double> baselines,
                                                     double confidence = kDefaultConfidence);

/// Returns the mean of all scores before, and one standard deviation below and above it, ascending. There are
/// at least two scores.
[[nodiscard]] std::vector<double> usualBaselines(const Groups& before);

/// Two one-sided tests (Schuirmann 1987) that a difference lies within a margin around 0.
struct Equivalence {
  double margin = 0.0;
  double pBelow = 0.0;  ///< of a difference of -margin or less
  double pAbove = 0.0;  ///< of a difference of margin or more
  double p = 0.0;       ///< the larger of the two: small says that the difference lies within the margin
  Interval interval;    ///< with confidence 1 - 2 alpha; within the margin exactly where p < alpha
};
/// Tests a difference with its standard error and degrees of freedom. `margin` and `error` > 0.
[[nodiscard]] Equivalence equivalence(double difference, double error, double df, double margin,
                                      double alpha = 1.0 - kDefaultConfidence);

}  // namespace torsio
