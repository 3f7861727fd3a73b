// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "assessment/statistics/ancova.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/crossed_model.h"

namespace torsio {

/// Marks of one trainee at two occasions, by rater; those that were not given are empty.
struct MarkedTrainee {
  std::size_t group = 0;
  std::vector<std::optional<double>> before;
  std::vector<std::optional<double>> after;  ///< the outcome
};

/// Returns the mean of the marks that were given; empty: none was.
[[nodiscard]] std::optional<double> meanMark(const std::vector<std::optional<double>>& marks);

/// Scores before and after of the trainees with a mark at both occasions, by group (complete cases).
struct CompleteCases {
  Groups before;
  Groups after;
  std::vector<std::size_t> leftOut;  ///< numbers of the trainees without one of the two, ascending
};
[[nodiscard]] CompleteCases completeCases(const std::vector<MarkedTrainee>& trainees, std::size_t groups);

/// Analysis of covariance that takes marks as they were given: trainee and rater as crossed random effects,
/// group and mean mark before as fixed ones, by restricted maximum likelihood.
struct MixedComparison {
  std::size_t trainees = 0;
  std::size_t marks = 0;
  double varianceTrainees = 0.0;
  double varianceRaters = 0.0;
  double varianceResidual = 0.0;
  double criterion = 0.0;  ///< minus twice the restricted log-likelihood
  double covariateMean = 0.0;
  ModelEstimate slope;
  std::vector<std::size_t> groups;      ///< numbers of those of which somebody takes part, ascending
  std::vector<ModelEstimate> adjusted;  ///< mean of each of `groups` where the score before is covariateMean
  struct Pair {
    std::size_t first = 0;
    std::size_t second = 0;
    ModelEstimate difference;  ///< first minus second
    Interval simultaneous;     ///< Bonferroni over the pairs
    double pHolm = 0.0;
  };
  std::vector<Pair> pairs;  ///< (0,1), (0,2), ..., (1,2) of `groups`, by their number in all
  Outcome<FTest> group = Outcome<FTest>::undefined(Text::tr("not computed"));
};
/// Compares groups. Trainees without a mark at one of the occasions take no part, and groups of which nobody
/// does are left out. Undefined for fewer than two groups, and as CrossedModel::fit().
[[nodiscard]] Outcome<MixedComparison> mixedComparison(const std::vector<MarkedTrainee>& trainees,
                                                       std::size_t groups,
                                                       double confidence = kDefaultConfidence);

/// Reliability of marks with holes: absolute agreement of raters drawn at random, from variances by
/// restricted maximum likelihood. With complete marks and no negative component the same as ICC(2,1) and
/// ICC(2,k).
struct HoledReliability {
  std::size_t marks = 0;
  std::size_t usualRaters = 0;  ///< marks that most targets have: k of the mean
  double varianceTargets = 0.0;
  double varianceRaters = 0.0;
  double varianceResidual = 0.0;
  double single = 0.0;     ///< of one rater
  double mean = 0.0;       ///< of the mean over usualRaters
  double semSingle = 0.0;  ///< standard error of measurement of one rater's mark
  double semMean = 0.0;    ///< of the mean over usualRaters
};
/// Estimates reliability from the marks that were given. Undefined as CrossedModel::fit().
[[nodiscard]] Outcome<HoledReliability> holedReliability(const IncompleteRatings& codersByUnit);

/// Marks that most trainees have at an occasion beyond what this one has: they are missing.
struct MissingCount {
  std::size_t before = 0;
  std::size_t after = 0;
};
/// Counts, for each trainee, the marks short of the number that most trainees have; ties: the larger one.
[[nodiscard]] std::vector<MissingCount> missingMarks(const std::vector<MarkedTrainee>& trainees);

/// How far missing marks can move an adjusted difference: every mark of the outcome that is missing is as low
/// as the scale allows in one group and as high in the other.
struct MissingBounds {
  std::size_t first = 0;
  std::size_t second = 0;
  Outcome<AdjustedDifference> worst = Outcome<AdjustedDifference>::undefined(Text::tr("not computed"));
  Outcome<AdjustedDifference> best = Outcome<AdjustedDifference>::undefined(Text::tr("not computed"));
};
/// Bounds every pair by analyses of covariance of all trainees: `worst` for the first group, then `best`. Who
/// has no score before gets the mean of those who have one. In groups outside the pair nothing is filled in.
[[nodiscard]] std::vector<MissingBounds> missingBounds(const std::vector<MarkedTrainee>& trainees,
                                                       std::size_t groups, double lowest, double highest);

}  // namespace torsio
