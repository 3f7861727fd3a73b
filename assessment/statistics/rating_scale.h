// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace torsio {

/// Expected distribution of one mark under a rating scale model.
struct CategoryOdds {
  std::vector<double> p;  ///< probability of each category, from 0
  double mean = 0.0;
  double variance = 0.0;
};

/// Thresholds of a rating scale, ln(P_k / P_(k-1)) = location - tau_k, prepared for many locations: each
/// probability is its neighbour's times a ratio, which takes two exponentials per location instead of one per
/// category.
class RatingScale {
 public:
  /// `tau`: tau_1 .. tau_K, at least one.
  explicit RatingScale(const std::vector<double>& tau);

  /// Computes `out` at ability - severity, in logits.
  void at(double location, CategoryOdds& out) const;

 private:
  [[nodiscard]] double exponent(double location, std::size_t k) const;
  [[nodiscard]] bool byQuotients(double location, std::vector<double>& p) const;
  void byExponentials(double location, std::vector<double>& p) const;

  std::vector<double> sums_;        // of the thresholds below
  std::vector<double> up_;          // exp(-threshold)
  std::vector<double> down_;        // exp(threshold)
  std::vector<double> categories_;  // 0 .. K
  bool near_ = true;                // the thresholds allow computation by ratios
};

}  // namespace torsio
