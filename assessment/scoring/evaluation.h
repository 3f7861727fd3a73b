// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/scoring/instrument.h"

namespace torsio {

/// Version of everything in this file; stored beside each result.
inline constexpr const char* kEvaluationFormulaVersion = "evaluation-1";

/// One mark: a rater scores one index of one model. Empty steps are a mark that was not given.
struct EvaluationRating {
  std::string model;
  std::string rater;
  std::size_t raterClass = 0;  ///< position in EvaluationInstrument::classes
  std::size_t index = 0;       ///< position in EvaluationInstrument::indices
  std::optional<std::int64_t> steps;
};

/// All marks of one rater for one model.
struct RaterSheet {
  std::string rater;
  std::size_t raterClass = 0;
  std::vector<std::optional<std::int64_t>> steps;  ///< one an index
};

struct ModelRatings {
  std::string model;
  std::vector<RaterSheet> sheets;  ///< ordered by class, then by rater
};

/// Groups marks by model, in the order in which the models first appear. Throws Error{kBadData} that names
/// rater, index and model when a mark lies outside the scale, appears twice, or when a rater appears in two
/// classes.
[[nodiscard]] std::vector<ModelRatings> groupRatings(const EvaluationInstrument& instrument,
                                                     std::span<const EvaluationRating> ratings);

/// Policy for missing marks.
enum class MissingPolicy {
  kRefuse,         ///< any missing mark is an error
  kAvailableCase,  ///< each index uses the marks it has; a weighted class without any mark is an error
  kListWise,     ///< a rater with a missing mark is left out altogether; an empty weighted class is an error
  kRenormalise,  ///< available-case, and the weights of the classes that have marks are divided by their sum
};

struct EvaluationPolicy {
  MissingPolicy missing = MissingPolicy::kAvailableCase;
  bool zeroWeightClassesInVariance = false;  ///< whether a class of weight 0 enters the sum of Eq. 26
  std::int64_t minimumPerClass = 1;          ///< below it the flag "few raters" is set
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
  std::vector<std::optional<double>> classMeans;  ///< one a class; empty where nobody rated
  std::vector<std::int64_t> classCounts;
  std::vector<std::string> flags;
};

/// A rater's own comprehensive score: Eq. 27 applied to one rater's marks. Empty with a missing mark.
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
  /// Eqs. 25 and 26 over the composites of complete raters; its m equals n27 when nothing is missing.
  std::optional<ScoreStatistics> compositeStatistics;
  std::int64_t missing = 0;
  std::vector<std::string> flags;  ///< "available-case", "list-wise", "renormalised", "few raters"; sorted
};

/// Evaluates one model (paper Eqs. 25, 26, 27). Throws Error{kBadData} naming class and index when the policy
/// refuses, Error{kBadParameter} for an instrument that breaks its rules.
[[nodiscard]] ModelEvaluation evaluateModel(const EvaluationInstrument& instrument,
                                            const ModelRatings& ratings, const EvaluationPolicy& policy = {});

/// Evaluates all models of a table of marks. Throws as groupRatings and evaluateModel.
[[nodiscard]] std::vector<ModelEvaluation> evaluate(const EvaluationInstrument& instrument,
                                                    std::span<const EvaluationRating> ratings,
                                                    const EvaluationPolicy& policy = {});

/// Eqs. 25 to 27 for complete marks, without any allocation: for repeated evaluation (resampling,
/// simulation). Made for fixed class sizes, none of weight 0; refuses class sizes whose common multiple is
/// too large. One thread an object.
class EvaluationKernel {
 public:
  /// Prepares the kernel. `raterClasses`: the class of each rater, in the order of the rows given to run().
  EvaluationKernel(const EvaluationInstrument& instrument, std::span<const std::size_t> raterClasses);

  /// Evaluates `steps`, raters x indices, row-major: fills m and s2 (one an index) and returns N. Gives the
  /// values of evaluateModel, bit for bit.
  double run(std::span<const std::int64_t> steps, std::span<double> m, std::span<double> s2);

 private:
  EvaluationInstrument instrument_;
  std::vector<std::size_t> raterClasses_;
  std::vector<std::int64_t> classCounts_;
  std::vector<std::int64_t> sums_;         // class x index
  std::vector<std::int64_t> squares_;      // index
  std::vector<std::int64_t> meanFactors_;  // weight x L / n of each class
  std::vector<std::int64_t> indexWeights_;
  std::int64_t indexWeightSum_ = 1;
  std::int64_t commonDenominator_ = 1;
};

}  // namespace torsio
