// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"

namespace torsio {

/// One result as text: a row of cohort.csv. Fields that do not apply are empty.
struct CohortCsvRow {
  std::string section{};  ///< sectionName()
  std::string item{};     ///< rater, trainee or scoring sheet; "all" for a summary
  std::string group{};
  std::string model{};  ///< tissue model; scoring sheet with revision and criterion code; program version
  std::string index{};  ///< of the instrument; rater code for "rater_mark" and "criterion_mark"; revision of
                        ///< a scoring sheet; number of a twist
  std::string occasion{};
  std::string statistic{};
  std::string value{};  ///< resultText()
  std::string n{};
  std::string flags{};  ///< joined by "; "
};

/// Returns the shortest text that reads back as the same number, a word, or an interval "[1, 2]"; empty if
/// undefined.
[[nodiscard]] std::string resultText(const ResultValue& value);

/// Lists the lines of a ledger as rows of cohort.csv, in order.
[[nodiscard]] std::vector<CohortCsvRow> cohortCsvRows(const Ledger& ledger);

/// Adds a line of cells in csvCell() format, ended by \r\n.
void appendCsvLine(std::string& text, std::span<const std::string> cells);

/// Formats cohort.csv in csvCell() format, with a header: comma-separated, decimal point, line ends \r\n. No
/// byte order mark.
[[nodiscard]] std::string cohortCsvText(const std::vector<CohortCsvRow>& rows);
[[nodiscard]] std::string cohortCsvText(const Ledger& ledger);

}  // namespace torsio
