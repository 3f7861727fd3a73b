// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"

namespace torsio {

/// One result as text: a line of cohort.csv. Empty fields do not apply.
struct CohortCsvRow {
  std::string section{};  ///< sectionName()
  std::string item{};     ///< rater, trainee or scoring sheet; "all" for a summary
  std::string group{};
  std::string
      model{};  ///< of tissue; scoring sheet, revision and code of a criterion; version of the program
  std::string index{};  ///< of the instrument; a rater's code for "rater_mark" and "criterion_mark"; the
                        ///< revision of a scoring sheet; the number of a twist
  std::string occasion{};
  std::string statistic{};
  std::string value{};  ///< resultText()
  std::string n{};
  std::string flags{};  ///< joined by "; "
};

/// Returns the shortest text that reads back as the same number, or a word; empty when undefined.
[[nodiscard]] std::string resultText(const ResultValue& value);

/// Names a row by its first seven cells, as they stand in the file: keyAddress() of its result.
[[nodiscard]] std::string numberAddress(const CohortCsvRow& row);

/// Lists the results of a ledger as lines of cohort.csv, in their order.
[[nodiscard]] std::vector<CohortCsvRow> cohortCsvRows(const Ledger& ledger);
/// As above, of a cohort that is analysed for it.
[[nodiscard]] std::vector<CohortCsvRow> cohortCsvRows(const CohortInputs& inputs);

/// Writes cohort.csv as csvCell() writes cells, with a header line: comma, point as decimal separator, line
/// ends \r\n. No byte order mark.
[[nodiscard]] std::string cohortCsvText(const std::vector<CohortCsvRow>& rows);
[[nodiscard]] std::string cohortCsvText(const Ledger& ledger);

}  // namespace torsio
