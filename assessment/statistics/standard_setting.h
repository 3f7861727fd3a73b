// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

/// Cut score between trainees judged not yet able and able; higher scores are better.
struct ContrastingGroups {
  double meanNovices = 0.0;
  double meanMasters = 0.0;
  double deviationNovices = 0.0;
  double deviationMasters = 0.0;
  double cutNormal = 0.0;           ///< where the two fitted normals intersect between the means
  std::optional<double> otherRoot;  ///< the intersection to reject; empty for equal variances
  double falsePass = 0.0;           ///< share of novices above cutNormal, by their normal
  double falseFail = 0.0;
  double midpoint = 0.0;
  std::optional<double> cutLogistic;  ///< 50 % point; empty if the groups do not overlap
  std::vector<double> logistic;       ///< intercept, slope
  std::vector<double> logisticErrors;
};
/// Computes the cut score. Undefined for fewer than two in a group, no variation, means in the wrong order,
/// or no intersection between the means.
[[nodiscard]] Outcome<ContrastingGroups> contrastingGroups(std::span<const double> novices,
                                                           std::span<const double> masters);

struct Angoff {
  std::vector<double> judgeTotals;  ///< items that a borderline trainee gets right, by judge
  double cut = 0.0;
  double percent = 0.0;
  std::optional<double> deviation;  ///< between judges; empty for a single judge
  std::optional<double> error;
};
/// Computes Angoff's cut score. `percent`: judges x items, probability in percent that a borderline trainee
/// succeeds. Undefined without judges.
[[nodiscard]] Outcome<Angoff> angoff(const NumberTable& percent);

struct BorderlineRegression {
  double intercept = 0.0;
  double slope = 0.0;
  double cut = 0.0;    ///< predicted score at the borderline rating
  double error = 0.0;  ///< standard error of the predicted mean
  double rSquared = 0.0;
};
/// Regresses score on global rating; the cut lies at `borderline`. Undefined for fewer than three trainees or
/// equal ratings.
[[nodiscard]] Outcome<BorderlineRegression> borderlineRegression(std::span<const double> globalRating,
                                                                 std::span<const double> score,
                                                                 double borderline);

enum class Better { kLower, kHigher };

struct ProficiencyOptions {
  Better better = Better::kLower;
  bool logScale = false;  ///< for times: computed on logarithms, reported on the original scale
  bool dropOutliers =
      false;               ///< excludes experts beyond 1.96 standard deviations, once, and reports how many
  double coverage = 0.90;  ///< share of experts that the tolerance bound covers
  double confidence = 0.95;
};
/// Thresholds from the centre's own experts, on the worse side: mean + SD if lower is better.
struct ProficiencyThreshold {
  std::size_t experts = 0;
  std::size_t dropped = 0;
  double mean = 0.0;
  double deviation = 0.0;
  double oneDeviation = 0.0;
  double twoDeviations = 0.0;
  double toleranceFactor = 0.0;  ///< k of the one-sided normal tolerance bound
  double toleranceBound = 0.0;
};
/// Computes the threshold. Undefined for fewer than two experts, no variation, or nonpositive values on the
/// log scale.
[[nodiscard]] Outcome<ProficiencyThreshold> proficiencyThreshold(std::span<const double> experts,
                                                                 const ProficiencyOptions& options = {});

/// Returns the attempt (from 1) by which a trainee has passed `consecutive` times in a row and `further`
/// times after that, not necessarily in a row; empty if never.
[[nodiscard]] std::optional<std::size_t> proficientAt(std::span<const double> attempts, double threshold,
                                                      Better better, std::size_t consecutive = 2,
                                                      std::size_t further = 0);

/// Returns the probability that proficientAt() succeeds within so many attempts by chance alone, with
/// independent passes of probability `pass`.
[[nodiscard]] double proficientProbability(double pass, std::size_t attempts, std::size_t consecutive = 2,
                                           std::size_t further = 0);

}  // namespace torsio
