// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace torsio {

/// Covariance C(lag) of Eq. 5, unit sill, as a function of the lag over the range, u:
/// Gaussian exp(-u^2); exponential exp(-u); spherical 1 - 3u/2 + u^3/2 up to u = 1, then 0;
/// Matern 3/2 (1 + sqrt3 u) exp(-sqrt3 u); Matern 5/2 (1 + sqrt5 u + 5u^2/3) exp(-sqrt5 u).
enum class Covariance { kGaussian, kExponential, kSpherical, kMatern32, kMatern52 };

/// Returns the covariance C at `lag` >= 0 for `range` > 0. The variogram of Eq. 3 is gamma = 1 - C.
[[nodiscard]] double covarianceAt(Covariance covariance, double lag, double range);

/// Trend that the weights reproduce exactly.
enum class Drift {
  kConstant,  ///< ordinary kriging: Eq. 16 as printed
  kLinear,    ///< universal kriging: exact for a uniform twist
};

struct KrigingOptions {
  Covariance covariance = Covariance::kMatern52;
  /// Range as a multiple of the mean sample spacing, which keeps the condition number independent of the
  /// number of samples.
  double rangeInSpacings = 20.0;
  double nugget = 0.0;  ///< relative to the sill; raised only when a pivot fails
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
/// abscissae only; a query equal to a sample returns that sample exactly. Immutable after construction, so
/// copies and threads may share it.
class Kriging1d {
 public:
  /// Prepares kriging from `samples`: strictly increasing, finite, at least 2. Throws Error{kBadParameter};
  /// also when the covariance matrix stays singular with the largest nugget tried (a range far beyond the
  /// samples).
  Kriging1d(std::span<const double> samples, const KrigingOptions& options = {});

  /// Solves for the weights of a query; one outside the samples is clamped to the nearer end.
  [[nodiscard]] KrigingWeights weights(double query) const;
  /// Estimates the value at a query from `values`, one a sample.
  [[nodiscard]] double estimate(double query, std::span<const double> values) const;
  [[nodiscard]] std::span<const double> samples() const noexcept { return samples_; }
  [[nodiscard]] const KrigingOptions& options() const noexcept { return options_; }
  /// Returns how many samples take part in one estimate: the window, or all.
  [[nodiscard]] int windowSize() const noexcept { return window_; }
  /// Returns the nugget asked for, or the first of 1e-12, 1e-11 .. 1e-8 with which every pivot held.
  [[nodiscard]] double nuggetUsed() const noexcept { return nuggetUsed_; }
  /// Returns the condition number (estimate in the 1-norm) of the worst covariance matrix in use, nugget
  /// included.
  [[nodiscard]] double conditionNumber() const noexcept { return conditionNumber_; }

 private:
  friend class KrigingTable;
  struct Systems;

  void chooseNugget(Systems& systems);
  [[nodiscard]] int firstOf(double query) const;
  void solve(double query, int first, std::span<double> lambda, double* variance) const;

  std::vector<double> samples_;
  KrigingOptions options_;
  int window_ = 0;
  double spacing_ = 1.0;
  double nuggetUsed_ = 0.0;
  double conditionNumber_ = 1.0;
  std::shared_ptr<const Systems> systems_;  // factorised: a window each, one for all when equally spaced
};

/// The weights of many queries in one piece of memory, for fields that change while the places do not: one
/// row of `windowSize()` weights a query. Immutable.
class KrigingTable {
 public:
  KrigingTable(const Kriging1d& kriging, std::span<const double> queries);

  [[nodiscard]] int size() const noexcept { return static_cast<int>(first_.size()); }
  [[nodiscard]] int width() const noexcept { return width_; }
  /// Returns the first sample of each query's row.
  [[nodiscard]] std::span<const int> first() const noexcept { return first_; }
  /// Returns all weights, row after row.
  [[nodiscard]] std::span<const double> lambda() const noexcept { return lambda_; }
  [[nodiscard]] std::span<const double> row(int query) const noexcept {
    return std::span(lambda_).subspan(static_cast<std::size_t>(query) * static_cast<std::size_t>(width_),
                                      static_cast<std::size_t>(width_));
  }

 private:
  int width_ = 0;
  std::vector<int> first_;
  std::vector<double> lambda_;
};

}  // namespace torsio
