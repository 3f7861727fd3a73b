// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/report/cohort_csv.h"
#include "assessment/report/number_format.h"
#include "assessment/statistics/values.h"
#include "sim/base/text.h"

namespace torsio {

/// Joins the flags of a whole cohort and those of one row: "demonstration data; marks missing".
[[nodiscard]] std::string joinFlags(const std::vector<Text>& common, const std::vector<std::string>& own);

/// Collects rows of the table of numbers that share their place and differ in statistic and value.
class CsvRows {
 public:
  explicit CsvRows(std::vector<CohortCsvRow>& out) : out_(out) {}

  CohortCsvRow place;

  /// What is no number: a hash.
  void addText(const std::string& statistic, const std::string& value, std::int64_t n) {
    CohortCsvRow row = place;
    row.statistic = statistic;
    row.value = value;
    row.n = std::to_string(n);
    out_.push_back(row);
  }

  void addInterval(const std::string& statistic, double value, const std::optional<Interval>& interval,
                   std::int64_t n) {
    add(statistic, value, n);
    if (!interval) {
      return;
    }
    add(statistic + "_lower_95", interval->lower, n);
    add(statistic + "_upper_95", interval->upper, n);
  }

  void add(const std::string& statistic, const std::optional<double>& value, std::int64_t n) {
    CohortCsvRow row = place;
    row.statistic = statistic;
    if (value) {
      row.value = formatExact(*value);
    }
    row.n = std::to_string(n);
    if (!value) {
      row.flags += row.flags.empty() ? "undefined" : "; undefined";
    }
    out_.push_back(row);
  }

 private:
  std::vector<CohortCsvRow>& out_;
};

/// Adds the criteria: every scoring sheet that was used with its anchors, what each group and trainee got for
/// each criterion, and every mark of it (criteria_section.cpp).
void addCriteriaRows(const CohortInputs& inputs, std::vector<CohortCsvRow>& out);

}  // namespace torsio
