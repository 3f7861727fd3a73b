// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/contracts.h"
#include "sim/core/text.h"

namespace torsio {

/// A statistic, or the reason why it is undefined for these data. Never 0 or NaN in place of a value.
template <class T>
class Outcome {
 public:
  Outcome(T value) : value_(std::move(value)) {}  // NOLINT: a value is an outcome
  [[nodiscard]] static Outcome undefined(Text reason) { return Outcome(std::nullopt, std::move(reason)); }

  [[nodiscard]] explicit operator bool() const noexcept { return value_.has_value(); }
  [[nodiscard]] const T& value() const {
    TORSIO_EXPECTS(value_.has_value());
    return *value_;
  }
  [[nodiscard]] const T* operator->() const { return &value(); }
  [[nodiscard]] const T& operator*() const { return value(); }
  /// Returns the reason: a clause without full stop, "every rating is the same".
  [[nodiscard]] const Text& reason() const noexcept { return reason_; }

 private:
  Outcome(std::nullopt_t, Text reason) : reason_(std::move(reason)) {}

  std::optional<T> value_;
  Text reason_;
};

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

/// A complete table of numbers: rows are targets (trainees), columns are raters, items or occasions.
class NumberTable {
 public:
  NumberTable() = default;
  NumberTable(std::size_t rows, std::size_t columns) : columns_(columns), values_(rows * columns, 0.0) {}
  /// Throws ContractError if the rows differ in length.
  explicit NumberTable(const std::vector<std::vector<double>>& rows) {
    columns_ = rows.empty() ? 0 : rows.front().size();
    for (const std::vector<double>& row : rows) {
      TORSIO_EXPECTS(row.size() == columns_);
      for (const double value : row) {
        values_.push_back(value);
      }
    }
  }

  [[nodiscard]] std::size_t rows() const noexcept { return columns_ == 0 ? 0 : values_.size() / columns_; }
  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  [[nodiscard]] double& at(std::size_t row, std::size_t column) { return values_[row * columns_ + column]; }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return values_[row * columns_ + column];
  }
  /// Returns all numbers, row after row.
  [[nodiscard]] std::span<const double> values() const noexcept { return values_; }
  [[nodiscard]] std::vector<double> row(std::size_t r) const {
    return {values_.begin() + static_cast<std::ptrdiff_t>(r * columns_),
            values_.begin() + static_cast<std::ptrdiff_t>((r + 1) * columns_)};
  }
  [[nodiscard]] std::vector<double> column(std::size_t c) const {
    std::vector<double> out;
    for (std::size_t r = 0; r < rows(); ++r) {
      out.push_back(at(r, c));
    }
    return out;
  }

 private:
  std::size_t columns_ = 0;
  std::vector<double> values_;
};

inline constexpr double kDefaultConfidence = 0.95;

}  // namespace torsio
