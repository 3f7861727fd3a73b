// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/rating/instrument.h"
#include "assessment/scoring/model_ratings.h"

namespace torsio {

/// Version of the formulas in this file; stored with each result.
inline constexpr const char* kEvaluationFormulaVersion = "evaluation-1";

/// Treatment of missing marks.
enum class MissingPolicy {
  kRefuse,         ///< any missing mark is an error
  kAvailableCase,  ///< each index uses the marks it has; a weighted class without marks is an error
  kListWise,       ///< a rater with a missing mark is excluded; an empty weighted class is an error
  kRenormalise,    ///< available-case, with the weights of the classes that have marks rescaled to sum to 1
};

struct EvaluationPolicy {
  MissingPolicy missing = MissingPolicy::kAvailableCase;
  bool zeroWeightClassesInVariance = false;  ///< whether a class of weight 0 enters the sum of Eq. 26
  std::int64_t minimumPerClass = 1;          ///< fewer set the flag "few raters"
};

/// Statistics of one index of one model, in points. `m` and `s2` are the exact values rounded once.
struct ScoreStatistics {
  double m = 0.0;   ///< Eq. 25: sum over classes of weight x class mean
  double s2 = 0.0;  ///< Eq. 26: mean squared distance from m over all raters, divisor n
  std::int64_t n = 0;
  std::int64_t missing = 0;
  double min = 0.0;
  double max = 0.0;
  double plainMean = 0.0;
  double populationVariance = 0.0;                ///< about the plain mean, divisor n
  std::optional<double> sampleVariance;           ///< divisor n - 1; empty for one rating
  double classWeightedMoment = 0.0;               ///< sum of weight x mean of (x - m)^2 in the class
  std::optional<double> standardError;            ///< of m; empty when a weighted class has one rating
  std::optional<double> standardErrorDf;          ///< Welch-Satterthwaite; empty without variation
  std::vector<std::optional<double>> classMeans;  ///< one per class; empty without marks
  std::vector<std::int64_t> classCounts;
  std::vector<std::string> flags;
};

/// One rater's comprehensive score: Eq. 27 applied to their marks. Empty with a missing mark.
struct RaterComposite {
  std::string rater;
  std::size_t raterClass = 0;
  std::optional<double> score;
};

struct ModelEvaluation {
  std::string model;
  double n27 = 0.0;  ///< Eq. 27: N, the comprehensive score
  std::vector<ScoreStatistics> indices;
  std::vector<RaterComposite> composites;
  /// Eqs. 25 and 26 over the composites of complete raters; m equals n27 if nothing is missing.
  std::optional<ScoreStatistics> compositeStatistics;
  std::int64_t missing = 0;
  std::vector<std::string> flags;  ///< "available-case", "list-wise", "renormalised", "few raters"; sorted
};

/// Evaluates one model (paper Eqs. 25, 26, 27). Throws Error{kBadData} naming class and index if the policy
/// forbids a missing mark, Error{kBadParameter} for an invalid instrument.
[[nodiscard]] ModelEvaluation evaluateModel(const EvaluationInstrument& instrument,
                                            const ModelRatings& ratings, const EvaluationPolicy& policy = {});

/// Evaluates every model in a list of marks. Throws like groupRatings and evaluateModel.
[[nodiscard]] std::vector<ModelEvaluation> evaluate(const EvaluationInstrument& instrument,
                                                    std::span<const EvaluationRating> ratings,
                                                    const EvaluationPolicy& policy = {});

}  // namespace torsio
