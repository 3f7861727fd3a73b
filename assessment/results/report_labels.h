// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"
#include "assessment/results/report_model.h"
#include "assessment/statistics/values.h"
#include "sim/core/text.h"

// Texts shared by several sections of the report.
namespace torsio {

/// Builds the cells of a table that show results with a common key.
class CellsAt {
 public:
  explicit CellsAt(ResultKey place) : place_(std::move(place)) {}
  [[nodiscard]] ReportCell operator()(const char* statistic, const Text& shown) const {
    ResultKey key = place_;
    key.statistic = statistic;
    return {shown, std::move(key)};
  }

 private:
  ResultKey place_;
};
/// Returns the cells for the comparison of two groups.
[[nodiscard]] inline CellsAt cellsOfPair(const CohortInputs& inputs, std::size_t first, std::size_t second) {
  return CellsAt({.section = ResultSection::kComparison,
                  .group = first,
                  .against = second,
                  .occasion = inputs.occasions.size() - 1});
}

/// Formats a value with its interval, "1.234 [1.000, 1.500]", three decimals; without an interval, the value
/// alone.
[[nodiscard]] std::string withInterval(double value, const std::optional<Interval>& interval);
/// Formats an interval alone, "[1.000, 1.500]", three decimals.
[[nodiscard]] std::string intervalText(const Interval& interval);
/// Describes why a statistic is missing: "not defined: every rating is the same". `reason`: from an Outcome.
[[nodiscard]] Text notDefined(const Text& reason);
/// Returns "Mean: Time (s)" or "Median: Time (s)", for the column of a quantity.
[[nodiscard]] Text meanTitle(Quantity quantity);
[[nodiscard]] Text medianTitle(Quantity quantity);
/// Formats a p value with its letter: "p < 0.001", "p = 0.032".
[[nodiscard]] std::string equalsP(double p);

}  // namespace torsio
