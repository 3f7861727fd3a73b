// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/study_analysis.h"
#include "assessment/statistics/values.h"

// Rows of cohort.csv as they are gathered. Private to assessment/results.
namespace torsio {

/// Joins the flags of all rows and those of some.
[[nodiscard]] std::string csvFlags(const std::vector<Text>& common, const std::vector<std::string>& own);

/// Collects rows that share their place and differ in statistic and value.
class CsvRows {
 public:
  explicit CsvRows(std::vector<CohortCsvRow>& out) : out_(out) {}

  CohortCsvRow place;

  /// Adds what is no number: a hash, a word.
  void addText(const std::string& statistic, const std::string& value, std::int64_t n);
  /// Adds a number, and its interval as `statistic` with _lower_95 and _upper_95.
  void addInterval(const std::string& statistic, double value, const std::optional<Interval>& interval,
                   std::int64_t n);
  /// Adds an interval by itself; `statistic` says of what and how wide.
  void addBounds(const std::string& statistic, const Interval& interval, std::int64_t n);
  /// Adds a number; empty: undefined.
  void add(const std::string& statistic, const std::optional<double>& value, std::int64_t n);

 private:
  std::vector<CohortCsvRow>& out_;
};

/// Lists all numbers: `shown` is what of `inputs` may be seen, `study` its analysis, empty without marks.
[[nodiscard]] std::vector<CohortCsvRow> csvRowsOf(const CohortInputs& inputs, const CohortInputs& shown,
                                                  const std::optional<StudyAnalysis>& study);

/// Adds the criteria: every scoring sheet that was used with its anchors, what each group and trainee got for
/// each criterion, and every mark of it (criteria_section.cpp).
void addCriteriaRows(const CohortInputs& inputs, std::vector<CohortCsvRow>& out);

/// Adds the numbers about raters and about groups.
void addStudyRows(const CohortInputs& inputs, const StudyAnalysis& study, std::vector<CohortCsvRow>& out);

}  // namespace torsio
