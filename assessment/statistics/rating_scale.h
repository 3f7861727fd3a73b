// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace torsio {

/// What a rating scale model expects of one mark.
struct CategoryOdds {
  std::vector<double> p;  ///< probability of each category, from 0
  double mean = 0.0;
  double variance = 0.0;
};

/// The thresholds of a rating scale, ln(P_k / P_(k-1)) = location - tau_k, ready for many locations: each
/// probability is that of the neighbour times a quotient, which takes two exponentials a location instead of
/// one a category.
class RatingScale {
 public:
  /// `tau`: tau_1 .. tau_K, one at least.
  explicit RatingScale(const std::vector<double>& tau);

  /// Computes `out` for ability - severity, in logits.
  void at(double location, CategoryOdds& out) const;

 private:
  [[nodiscard]] double exponent(double location, std::size_t k) const;
  [[nodiscard]] bool byQuotients(double location, std::vector<double>& p) const;
  void byExponentials(double location, std::vector<double>& p) const;

  std::vector<double> sums_;        // of the thresholds below
  std::vector<double> up_;          // exp(-threshold)
  std::vector<double> down_;        // exp(threshold)
  std::vector<double> categories_;  // 0 .. K
  bool near_ = true;                // thresholds are such that quotients can be used
};

}  // namespace torsio
