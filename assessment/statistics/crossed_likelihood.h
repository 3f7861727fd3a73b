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

// What CrossedModel minimises. Private to assessment/statistics.

inline constexpr std::size_t kParts = 3;  ///< variances: residual, targets, raters
inline constexpr std::size_t kResidual = 0;
inline constexpr std::size_t kTargets = 1;
inline constexpr std::size_t kRaters = 2;
using Parts = std::array<double, kParts>;

/// The restricted likelihood of crossed targets and raters, from sums over the marks: with n marks it needs
/// no table of n x n.
class CrossedLikelihood {
 public:
  /// `fixed` as CrossedModel::fit has it, `raters`: how many. Check separable() before anything else.
  CrossedLikelihood(const std::vector<CrossedMark>& marks, const NumberTable& fixed, std::size_t raters);
  ~CrossedLikelihood();
  CrossedLikelihood(const CrossedLikelihood&) = delete;
  CrossedLikelihood& operator=(const CrossedLikelihood&) = delete;
  CrossedLikelihood(CrossedLikelihood&&) = delete;
  CrossedLikelihood& operator=(CrossedLikelihood&&) = delete;

  /// False: the fixed coefficients cannot be told apart.
  [[nodiscard]] bool separable() const noexcept { return separable_; }
  /// Sum of squares that the fixed part leaves by least squares.
  [[nodiscard]] double squaresLeft() const;

  /// Variances from a grid of ratios, from which Newton's method goes down into the lowest place. 0 for the
  /// residual one: there is none.
  [[nodiscard]] Parts start() const;

  /// The criterion at given variances, its slope and curvature by them, and the coefficients there.
  struct Derivatives {
    bool defined = false;
    double criterion = std::numeric_limits<double>::infinity();
    Parts slope{};
    std::array<Parts, kParts> curvature{};
    std::array<Parts, kParts> expected{};  ///< of the curvature
    std::vector<double> coefficients{};
    NumberTable covariance{};                            ///< of the coefficients
    std::array<NumberTable, kParts> covarianceSlopes{};  ///< of the covariance by each variance
  };
  [[nodiscard]] Derivatives at(const Parts& variance) const;

  struct Sums;  ///< of crossed_likelihood.cpp alone

 private:
  std::unique_ptr<Sums> sums_;
  bool separable_ = false;
};

}  // namespace torsio
