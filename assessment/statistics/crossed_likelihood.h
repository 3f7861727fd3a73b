// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "assessment/statistics/crossed_model.h"
#include "assessment/statistics/values.h"

namespace torsio {

// The criterion minimised by CrossedModel. Private to assessment/statistics.

inline constexpr std::size_t kParts = 3;  ///< variance components: residual, targets, raters
inline constexpr std::size_t kResidual = 0;
inline constexpr std::size_t kTargets = 1;
inline constexpr std::size_t kRaters = 2;
using Parts = std::array<double, kParts>;

/// Restricted likelihood of crossed targets and raters, computed from sums over the marks without an n x n
/// matrix of n marks.
class CrossedLikelihood {
 public:
  /// `fixed`: see CrossedModel::fit; `raters`: number of raters. Check separable() first.
  CrossedLikelihood(const std::vector<CrossedMark>& marks, const NumberTable& fixed, std::size_t raters);
  ~CrossedLikelihood();
  CrossedLikelihood(const CrossedLikelihood&) = delete;
  CrossedLikelihood& operator=(const CrossedLikelihood&) = delete;
  CrossedLikelihood(CrossedLikelihood&&) = delete;
  CrossedLikelihood& operator=(CrossedLikelihood&&) = delete;

  /// False if the fixed coefficients cannot be separated.
  [[nodiscard]] bool separable() const noexcept { return separable_; }
  /// Residual sum of squares of the fixed part by least squares.
  [[nodiscard]] double squaresLeft() const;

  /// Returns starting variances for Newton's method from a grid of ratios. A residual variance of 0 means
  /// that the marks leave no residual.
  [[nodiscard]] Parts start() const;

  /// Criterion at given variances with its gradient and curvature, and the coefficients there.
  struct Derivatives {
    bool defined = false;
    double criterion = std::numeric_limits<double>::infinity();
    Parts slope{};
    std::array<Parts, kParts> curvature{};
    std::array<Parts, kParts> expected{};  ///< expected curvature
    std::vector<double> coefficients{};
    NumberTable covariance{};                            ///< of the coefficients
    std::array<NumberTable, kParts> covarianceSlopes{};  ///< derivative of the covariance by each variance
  };
  [[nodiscard]] Derivatives at(const Parts& variance) const;

  struct Sums;  ///< private to crossed_likelihood.cpp

 private:
  std::unique_ptr<Sums> sums_;
  bool separable_ = false;
};

}  // namespace torsio
