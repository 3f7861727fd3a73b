// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"

namespace torsio {

/// One row of cohort.csv: one number with everything that says what it is. Empty fields do not apply.
struct CohortCsvRow {
  std::string section{};  ///< "evaluation", "training", "scoring_sheet", "criterion", "agreement",
                          ///< "comparison", "trial", "competence", "deviation", "record"
  std::string item{};     ///< rater, trainee or trial; "all" for a summary
  std::string group{};
  std::string
      model{};  ///< of tissue; scoring sheet, revision and code of a criterion; version of the program
  std::string index{};  ///< of the instrument; a rater's code for "rater_mark" and "criterion_mark"; the
                        ///< revision of a scoring sheet; the number of a twist
  std::string occasion{};
  std::string statistic{};
  std::string value{};  ///< shortest text that reads back as the same number, or a hash; empty when undefined
  std::string n{};
  std::string flags{};  ///< joined by "; "
};

/// Names a row by its first seven cells, as they stand in the file: no two rows of a table share them.
[[nodiscard]] std::string numberAddress(const CohortCsvRow& row);

/// Lists all numbers of a cohort in tidy form. Same inputs, same rows in the same order.
[[nodiscard]] std::vector<CohortCsvRow> cohortCsvRows(const CohortInputs& inputs);

/// Writes the rows as csvCell() writes cells, with a header line: comma, point as decimal separator, line
/// ends \r\n. No byte order mark.
[[nodiscard]] std::string cohortCsvText(const std::vector<CohortCsvRow>& rows);

}  // namespace torsio
