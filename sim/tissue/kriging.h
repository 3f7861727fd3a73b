// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace torsio {

/// Covariance C(lag) of Eq. 5, unit sill.
enum class Covariance { kGaussian, kExponential, kSpherical, kMatern32, kMatern52 };

/// Trend that the weights reproduce exactly.
enum class Drift {
  kConstant,  ///< ordinary kriging: Eq. 16 as printed
  kLinear,    ///< universal kriging: exact for a uniform twist
};

struct KrigingOptions {
  Covariance covariance = Covariance::kMatern52;
  double rangeInSpacings = 20.0;  ///< range as a multiple of the mean sample spacing
  double nugget = 0.0;            ///< relative to the sill; raised only when a pivot fails
  Drift drift = Drift::kLinear;
  int window = 8;  ///< nearest samples used; 0: all (global)
};

/// Weights of one query: value = sum lambda_i Z_i over samples first .. first + size - 1 (Eq. 4, 9, 15).
struct KrigingWeights {
  int first = 0;
  std::vector<double> lambda;  ///< sum is 1 (Eq. 7)
  double variance = 0.0;       ///< Eq. 8, relative to the sill, >= 0
};

/// One-dimensional kriging along a ridge or the centreline (Eqs. 1-9, 15, 16). Weights depend on the
/// abscissae only; a query equal to a sample returns that sample exactly. Immutable after construction.
class Kriging1d {
 public:
  /// `samples`: strictly increasing, finite, at least 2. Throws Error{kBadParameter}.
  Kriging1d(std::span<const double> samples, const KrigingOptions& options = {});

  /// Queries outside the samples are clamped to the nearer end.
  [[nodiscard]] KrigingWeights weights(double query) const;
  /// `values`: one a sample.
  [[nodiscard]] double estimate(double query, std::span<const double> values) const;
  [[nodiscard]] std::span<const double> samples() const noexcept { return samples_; }
  [[nodiscard]] double nuggetUsed() const noexcept { return nuggetUsed_; }

 private:
  std::vector<double> samples_;
  KrigingOptions options_;
  double spacing_ = 1.0;
  double nuggetUsed_ = 0.0;
};

}  // namespace torsio
