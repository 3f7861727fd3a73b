// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/cone.h"

#include <boost/multiprecision/cpp_int.hpp>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
using Vector = std::vector<Rational>;

Rational product(const SparseRow& row, const Vector& y) {
  Rational sum = 0;
  for (const auto& [unknown, coefficient] : row) {
    sum += coefficient * y[unknown];
  }
  return sum;
}

/// Stiemke's alternative: either some y has row . y <= 0 for all rows and < 0 for one, or the rows have
/// weights w > 0 whose weighted sum is 0. The simplex method (with Bland's rule, which terminates) searches
/// for
/// w = 1 + v, v >= 0: sum of v row = - sum of row. There is one equation per unknown; each starts with its
/// own
/// artificial variable, whose sum is driven to zero.
class WeightSearch {
 public:
  WeightSearch(const std::vector<SparseRow>& rows, std::size_t unknowns)
      : rows_(rows), size_(unknowns), basis_(unknowns), value_(unknowns, 0) {
    for (const SparseRow& row : rows) {
      for (const auto& [unknown, coefficient] : row) {
        value_[unknown] -= coefficient;
      }
    }
    for (std::size_t i = 0; i < size_; ++i) {
      basis_[i] = rows.size() + i;
      inverse_.emplace_back(size_, 0);
      inverse_[i][i] = value_[i] < 0 ? -1 : 1;
      if (value_[i] < 0) {
        value_[i] = -value_[i];
      }
    }
  }

  /// Returns the direction that rules out such weights, or one along which every row stays zero.
  std::optional<Vector> direction() {
    for (;;) {
      const Vector y = price();
      const std::optional<std::size_t> entering = firstPositive(y);
      if (!entering) {
        break;
      }
      const Vector column = columnOf(*entering);
      pivot(leaving(column), *entering, column);
    }
    for (std::size_t i = 0; i < size_; ++i) {
      if (artificial(i) && value_[i] != 0) {
        return price();
      }
    }
    return flatDirection();
  }

 private:
  [[nodiscard]] bool artificial(std::size_t i) const { return basis_[i] >= rows_.size(); }

  /// Simplex multipliers for the sum of the artificial variables.
  [[nodiscard]] Vector price() const {
    Vector y(size_, 0);
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t k = 0; artificial(i) && k < size_; ++k) {
        y[k] += inverse_[i][k];
      }
    }
    return y;
  }

  [[nodiscard]] std::optional<std::size_t> firstPositive(const Vector& y) const {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (product(rows_[r], y) > 0) {
        return r;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] Vector columnOf(std::size_t row) const {
    Vector column;
    for (std::size_t i = 0; i < size_; ++i) {
      column.push_back(product(rows_[row], inverse_[i]));
    }
    return column;
  }

  /// The ratio test; the sum of artificial variables is bounded below, so one entry is positive.
  [[nodiscard]] std::size_t leaving(const Vector& column) const {
    std::optional<std::size_t> best;
    Rational smallest = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (column[i] <= 0) {
        continue;
      }
      const Rational ratio = value_[i] / column[i];
      if (!best || ratio < smallest || (ratio == smallest && basis_[i] < basis_[*best])) {
        best = i;
        smallest = ratio;
      }
    }
    TORSIO_EXPECTS(best.has_value());
    return *best;
  }

  void pivot(std::size_t out, std::size_t entering, const Vector& column) {
    basis_[out] = entering;
    value_[out] /= column[out];
    for (Rational& entry : inverse_[out]) {
      entry /= column[out];
    }
    for (std::size_t i = 0; i < size_; ++i) {
      if (i == out || column[i] == 0) {
        continue;
      }
      value_[i] -= column[i] * value_[out];
      for (std::size_t k = 0; k < size_; ++k) {
        inverse_[i][k] -= column[i] * inverse_[out][k];
      }
    }
  }

  /// Called if the weights exist. An artificial variable that no row can replace is a combination of unknowns
  /// on which no row depends.
  std::optional<Vector> flatDirection() {
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t r = 0; r < rows_.size() && artificial(i); ++r) {
        if (product(rows_[r], inverse_[i]) != 0) {
          pivot(i, r, columnOf(r));
        }
      }
      if (artificial(i)) {
        return inverse_[i];
      }
    }
    return std::nullopt;
  }

  const std::vector<SparseRow>& rows_;
  std::size_t size_;
  std::vector<std::size_t>
      basis_;  // row in the basis for each equation, or rows + i: its artificial variable
  Vector value_;
  std::vector<Vector> inverse_;  // of the basis
};

}  // namespace

std::optional<std::vector<double>> directionWithin(const std::vector<SparseRow>& rows, std::size_t unknowns) {
  const std::optional<Vector> direction = WeightSearch(rows, unknowns).direction();
  if (!direction) {
    return std::nullopt;
  }
  std::vector<double> out;
  for (const Rational& component : *direction) {
    out.push_back(component.convert_to<double>());
  }
  return out;
}

}  // namespace torsio
