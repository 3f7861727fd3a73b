// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// Allocation-free Eqs. 25 to 27 for complete marks, for repeated evaluation (resampling, simulation). Class
/// sizes are fixed and no class has weight 0. Not thread-safe.
class EvaluationKernel {
 public:
  /// True if every weighted class has a rater and the common multiple of the class sizes is small enough for
  /// exact integers in doubles.
  [[nodiscard]] static bool fits(const EvaluationInstrument& instrument,
                                 std::span<const std::size_t> raterClasses);

  /// Prepares the kernel; requires fits(). `raterClasses`: class of each rater, in the order of the rows
  /// given to run().
  EvaluationKernel(const EvaluationInstrument& instrument, std::span<const std::size_t> raterClasses);

  /// Evaluates `steps` (raters x indices, row-major): fills m and s2, one per index, and returns N. Bit for
  /// bit equal to evaluateModel.
  double run(std::span<const std::int64_t> steps, std::span<double> m, std::span<double> s2);

 private:
  EvaluationInstrument instrument_;
  std::vector<std::size_t> raterClasses_;
  std::vector<std::int64_t> sums_;         // class x index
  std::vector<std::int64_t> squares_;      // index
  std::vector<std::int64_t> meanFactors_;  // weight x L / n of each class
  std::vector<std::int64_t> indexWeights_;
  std::int64_t indexWeightSum_ = 1;
  std::int64_t commonDenominator_ = 1;
};

}  // namespace torsio
