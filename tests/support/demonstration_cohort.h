// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "sim/core/csv_cell.h"

namespace torsio::testing {

/// Returns the inputs of a report of the paper's study, with marks by the demonstration's rule and one
/// recording: thirty trainees in three groups, ten raters, forty raters of three models.
[[nodiscard]] CohortInputs demonstrationCohort();

// The texts of a cohort's report, for tests of their correctness.

/// Returns the inputs with scores and summaries updated to their marks.
[[nodiscard]] CohortInputs scored(CohortInputs in);
/// Returns the demonstration's cohort without the marks selected by `lost`.
[[nodiscard]] CohortInputs losing(const std::function<bool(const TrainingMark&)>& lost);
/// Returns the demonstration's cohort with each mark changed.
[[nodiscard]] CohortInputs marking(const std::function<void(TrainingMark&)>& change);

/// Returns the demonstration's cohort with three untwistings of the first group in one phase: two successful,
/// one of them after a relapse; in the third, blood flow never returned.
[[nodiscard]] CohortInputs withUntwistings();

/// Returns the demonstration's cohort without marks of the models by the rater class with the largest weight.
[[nodiscard]] CohortInputs aClassOfRatersIsMissing();

/// Returns null if there is none.
[[nodiscard]] const ReportFigure* figureNamed(const ReportModel& report, const std::string& id);
[[nodiscard]] const ReportTable* tableNamed(const ReportModel& report, const std::string& id);
/// Returns all paragraphs, one per line.
[[nodiscard]] std::string paragraphsOf(const ReportModel& report);
/// Returns the sentences of the first page, one per line.
[[nodiscard]] std::string firstPageOf(const ReportModel& report);
/// Returns the rows with this statistic in the table of numbers.
[[nodiscard]] std::vector<CohortCsvRow> rowsNamed(const CohortInputs& in, const std::string& statistic);
/// Returns their number.
[[nodiscard]] std::int64_t csvCount(const CohortInputs& in, const std::string& statistic);

/// A sentence or cell of a report, with its heading.
struct Said {
  std::string head;  ///< column title, if the text is a cell
  std::string text;
};
[[nodiscard]] std::vector<Said> everythingSaid(const ReportModel& report);
/// Returns everything, one text per line.
[[nodiscard]] std::string textOfAll(const CohortInputs& in);

/// Fails if a report or its table of numbers has a NaN or infinity, p = 0.000, an interval without its level,
/// a text with an unfilled placeholder, or a value neither present nor marked as undefined.
void expectWellSaid(const CohortInputs& in);

}  // namespace torsio::testing

namespace torsio {

/// Returns the rows of cohort.csv of a cohort.
inline std::vector<CohortCsvRow> cohortCsvRows(const CohortInputs& inputs) {
  return cohortCsvRows(analysedCohort(inputs).ledger);
}

/// Identifies a row by its first seven cells as in the file: keyAddress() of its result.
inline std::string numberAddress(const CohortCsvRow& row) {
  std::string address;
  for (const std::string* field :
       {&row.section, &row.item, &row.group, &row.model, &row.index, &row.occasion, &row.statistic}) {
    address += (field == &row.section ? "" : ",") + csvCell(*field);
  }
  return address;
}

}  // namespace torsio
