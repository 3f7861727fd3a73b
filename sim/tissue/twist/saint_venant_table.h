// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace torsio {

/// A value and its derivative.
struct ValueSlope {
  double value = 0.0;
  double slope = 0.0;
};

/// A smooth function on equally spaced nodes: cubic Hermite pieces, continuous with its derivative, the node
/// values exact. The look-up is noexcept, allocates nothing and uses + - * / only: it serves the servo tick.
class HermiteTable {
 public:
  HermiteTable() = default;
  /// Makes the function from `values`: at least 2, at first, first + step ... `monotone`: slopes are
  /// limited so that rising or falling values are never overshot (Fritsch and Carlson 1980).
  HermiteTable(double first, double step, std::vector<double> values, bool monotone);

  /// Returns value and slope at x; outside the nodes the nearer end value and slope 0.
  [[nodiscard]] ValueSlope at(double x) const noexcept;
  [[nodiscard]] double value(double x) const noexcept { return at(x).value; }

  [[nodiscard]] double first() const noexcept { return first_; }
  [[nodiscard]] double step() const noexcept { return step_; }
  [[nodiscard]] int nodes() const noexcept { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] double node(int index) const { return nodes_[static_cast<std::size_t>(index)].value; }

 private:
  void limitSlopes();

  double first_ = 0.0;
  double step_ = 1.0;
  double inverseStep_ = 1.0;
  std::vector<ValueSlope> nodes_;  // slope per step
};

}  // namespace torsio
