// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/values.h"

namespace torsio {

/// One mark of a rater for a target.
struct CrossedMark {
  std::size_t target = 0;
  std::size_t rater = 0;
  double value = 0.0;
};

/// A coefficient or a contrast of coefficients with its test.
struct ModelEstimate {
  double value = 0.0;
  double error = 0.0;
  double df = 0.0;  ///< Satterthwaite
  double t = 0.0;
  double p = 0.0;  ///< two-sided, of value 0
  Interval interval;
};

/// Linear mixed model with crossed random effects of targets and raters, fitted by restricted maximum
/// likelihood: mark = fixed part of the target + target + rater + residual. Uses every mark given; missing
/// ones need no imputation if missingness does not depend on the mark itself.
class CrossedModel {
 public:
  /// Fits the model. `fixed`: targets x coefficients, of full rank, constant within a target. Undefined with
  /// fewer than two targets or raters, no target with two marks, inseparable coefficients, or marks without
  /// residual variation.
  [[nodiscard]] static Outcome<CrossedModel> fit(const std::vector<CrossedMark>& marks,
                                                 const NumberTable& fixed);

  [[nodiscard]] std::size_t marks() const noexcept { return marks_; }
  [[nodiscard]] double varianceTargets() const noexcept { return varianceTargets_; }
  [[nodiscard]] double varianceRaters() const noexcept { return varianceRaters_; }
  [[nodiscard]] double varianceResidual() const noexcept { return varianceResidual_; }
  /// Returns minus twice the restricted log-likelihood, including all constants, as lme4 reports it.
  [[nodiscard]] double criterion() const noexcept { return criterion_; }
  [[nodiscard]] int iterations() const noexcept { return iterations_; }
  [[nodiscard]] const std::vector<double>& coefficients() const noexcept { return coefficients_; }

  /// Estimates sum of weights[j] x coefficient j, tested by Student's t with Satterthwaite's degrees of
  /// freedom.
  [[nodiscard]] ModelEstimate estimate(const std::vector<double>& weights,
                                       double confidence = kDefaultConfidence) const;
  /// Tests that all `contrasts` (rows, independent) are 0 by Wald's F with the degrees of freedom of Fai and
  /// Cornelius. Undefined if these are too few.
  [[nodiscard]] Outcome<FTest> test(const std::vector<std::vector<double>>& contrasts) const;

 private:
  CrossedModel() = default;

  std::size_t marks_ = 0;
  double varianceTargets_ = 0.0;
  double varianceRaters_ = 0.0;
  double varianceResidual_ = 0.0;
  double criterion_ = 0.0;
  int iterations_ = 0;
  std::vector<double> coefficients_;
  NumberTable covariance_;           // of the coefficients
  std::vector<NumberTable> slopes_;  // derivative of the covariance by each variance not held at 0
  NumberTable varianceCovariance_;   // of these variances
};

}  // namespace torsio
