// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "assessment/statistics/ancova.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/crossed_model.h"

namespace torsio {

/// One trainee's marks at two occasions, by rater; missing ones are empty.
struct MarkedTrainee {
  std::size_t group = 0;
  std::vector<std::optional<double>> before;
  std::vector<std::optional<double>> after;  ///< the outcome
};

/// Returns the mean of the marks given; empty if there are none.
[[nodiscard]] std::optional<double> meanMark(const std::vector<std::optional<double>>& marks);

/// Scores before and after by group, of trainees with a mark at both occasions (complete cases).
struct CompleteCases {
  Groups before;
  Groups after;
  std::vector<std::size_t> leftOut;  ///< indices of the trainees who lack one of the two, ascending
};
[[nodiscard]] CompleteCases completeCases(const std::vector<MarkedTrainee>& trainees, std::size_t groups);

/// Analysis of covariance of incomplete marks: trainee and rater as crossed random effects, group and mean
/// mark before as fixed effects, by restricted maximum likelihood.
struct MixedComparison {
  std::size_t trainees = 0;
  std::size_t marks = 0;
  double varianceTrainees = 0.0;
  double varianceRaters = 0.0;
  double varianceResidual = 0.0;
  double criterion = 0.0;  ///< minus twice the restricted log-likelihood
  double covariateMean = 0.0;
  ModelEstimate slope;
  std::vector<std::size_t> groups;      ///< indices of the groups with trainees in the analysis, ascending
  std::vector<ModelEstimate> adjusted;  ///< mean of each group at score before = covariateMean
  struct Pair {
    std::size_t first = 0;
    std::size_t second = 0;
    ModelEstimate difference;  ///< first minus second
    Interval simultaneous;     ///< Bonferroni over the pairs
    double pHolm = 0.0;
    Interval asHolm;  ///< excludes 0 exactly if pHolm < 1 - confidence (holmFactors())
  };
  std::vector<Pair> pairs;  ///< (0,1), (0,2), ..., (1,2) of `groups`, by index among all groups
  Outcome<FTest> group = Outcome<FTest>::undefined(Text::tr("not computed"));
};
/// Compares groups. Excludes trainees without a mark at one of the occasions, and groups left empty by that.
/// Undefined for fewer than two groups, and like CrossedModel::fit().
[[nodiscard]] Outcome<MixedComparison> mixedComparison(const std::vector<MarkedTrainee>& trainees,
                                                       std::size_t groups,
                                                       double confidence = kDefaultConfidence);

/// Reliability of incomplete marks: absolute agreement of random raters from restricted maximum likelihood
/// variances. For complete marks without negative components equal to ICC(2,1) and ICC(2,k).
struct IncompleteReliability {
  std::size_t marks = 0;
  std::size_t usualRaters = 0;  ///< most frequent number of marks per target: k of the mean
  double varianceTargets = 0.0;
  double varianceRaters = 0.0;
  double varianceResidual = 0.0;
  double single = 0.0;     ///< of a single rater
  double mean = 0.0;       ///< of the mean over usualRaters
  double semSingle = 0.0;  ///< standard error of measurement of a single rater's mark
  double semMean = 0.0;    ///< of the mean over usualRaters
};
/// Estimates reliability from the marks given. `groupOf`: group of each unit, within which units are
/// compared; empty: one group. Undefined like CrossedModel::fit().
[[nodiscard]] Outcome<IncompleteReliability> incompleteReliability(
    const IncompleteRatings& codersByUnit, const std::vector<std::size_t>& groupOf = {});

/// Marks missing at an occasion, compared with the most frequent number per trainee.
struct MissingCount {
  std::size_t before = 0;
  std::size_t after = 0;
};
/// Counts for each trainee how many marks are missing from the most frequent number; ties: the larger one.
[[nodiscard]] std::vector<MissingCount> missingMarks(const std::vector<MarkedTrainee>& trainees);

/// Bounds of an adjusted difference with missing outcomes imputed as low as the scale allows in one group and
/// as high as it allows in the other.
struct MissingBounds {
  std::size_t first = 0;
  std::size_t second = 0;
  Outcome<AdjustedDifference> worst = Outcome<AdjustedDifference>::undefined(Text::tr("not computed"));
  Outcome<AdjustedDifference> best = Outcome<AdjustedDifference>::undefined(Text::tr("not computed"));
};
/// Bounds every pair by analyses of covariance of all trainees: `worst` for the first group, then `best`.
/// Trainees without a score before get the mean of the others. Groups outside the pair are not imputed.
[[nodiscard]] std::vector<MissingBounds> missingBounds(const std::vector<MarkedTrainee>& trainees,
                                                       std::size_t groups, double lowest, double highest);

}  // namespace torsio
