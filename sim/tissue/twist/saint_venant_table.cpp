// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/saint_venant_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

// Derivative per step at node i of the cubic through four neighbours (fourth order inside, third at the
// ends); fewer nodes: the differences that exist.
double slopePerStep(const std::vector<double>& y, std::size_t i) {
  const std::size_t n = y.size();
  if (n == 2) {
    return y[1] - y[0];
  }
  if (n == 3) {
    if (i == 1) {
      return 0.5 * (y[2] - y[0]);
    }
    return i == 0 ? -1.5 * y[0] + 2.0 * y[1] - 0.5 * y[2] : 1.5 * y[2] - 2.0 * y[1] + 0.5 * y[0];
  }
  if (i >= 2 && i + 2 < n) {
    return (y[i - 2] - y[i + 2]) / 12.0 + (y[i + 1] - y[i - 1]) * (2.0 / 3.0);
  }
  if (i == 0) {
    return (-11.0 * y[0] + 18.0 * y[1] - 9.0 * y[2] + 2.0 * y[3]) / 6.0;
  }
  if (i == 1) {
    return (-2.0 * y[0] - 3.0 * y[1] + 6.0 * y[2] - y[3]) / 6.0;
  }
  if (i + 1 == n) {
    return (11.0 * y[i] - 18.0 * y[i - 1] + 9.0 * y[i - 2] - 2.0 * y[i - 3]) / 6.0;
  }
  return (2.0 * y[i + 1] + 3.0 * y[i] - 6.0 * y[i - 1] + y[i - 2]) / 6.0;
}

}  // namespace

HermiteTable::HermiteTable(double first, double step, std::vector<double> values, bool monotone)
    : first_(first), step_(step), inverseStep_(1.0 / step) {
  TORSIO_EXPECTS(values.size() >= 2 && step > 0.0);
  nodes_.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    nodes_.push_back({values[i], slopePerStep(values, i)});
  }
  if (monotone) {
    limitSlopes();
  }
}

void HermiteTable::limitSlopes() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double before = i > 0 ? nodes_[i].value - nodes_[i - 1].value : nodes_[1].value - nodes_[0].value;
    const double after = i + 1 < nodes_.size() ? nodes_[i + 1].value - nodes_[i].value : before;
    if (before * after <= 0.0) {
      nodes_[i].slope = 0.0;
      continue;
    }
    const double limit = 3.0 * std::min(std::abs(before), std::abs(after));
    const double magnitude =
        std::min(nodes_[i].slope * before > 0.0 ? std::abs(nodes_[i].slope) : 0.0, limit);
    nodes_[i].slope = before > 0.0 ? magnitude : -magnitude;
  }
}

ValueSlope HermiteTable::at(double x) const noexcept {
  const double u = (x - first_) * inverseStep_;
  const double top = static_cast<double>(nodes_.size() - 1);
  if (!(u >= 0.0)) {
    return {nodes_.front().value, 0.0};
  }
  if (u > top) {
    return {nodes_.back().value, 0.0};
  }
  const std::size_t cell = std::min(static_cast<std::size_t>(u), nodes_.size() - 2);
  const double t = u - static_cast<double>(cell);
  const ValueSlope& a = nodes_[cell];
  const ValueSlope& b = nodes_[cell + 1];
  // Newton-like form about the left node: exact there, and exact at the right node up to rounding.
  const double rise = b.value - a.value;
  const double c2 = 3.0 * rise - 2.0 * a.slope - b.slope;
  const double c3 = a.slope + b.slope - 2.0 * rise;
  if (t == 1.0) {
    return {b.value, b.slope * inverseStep_};
  }
  return {a.value + t * (a.slope + t * (c2 + t * c3)),
          (a.slope + t * (2.0 * c2 + 3.0 * t * c3)) * inverseStep_};
}

}  // namespace torsio
