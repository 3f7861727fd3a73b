// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/report_model.h"
#include "assessment/results/study_analysis.h"

namespace torsio {

/// What may be seen of a cohort, its analysis and all its numbers: made once for whoever needs both the table
/// of numbers and the report. The analysis takes seconds for 100,000 marks.
struct AnalysedCohort {
  CohortInputs shown;
  std::vector<Text> left;              ///< one sentence for each thing that was left out
  std::optional<StudyAnalysis> study;  ///< empty without marks
  std::vector<CohortCsvRow> rows;      ///< cohortCsvRows()
};

[[nodiscard]] AnalysedCohort analysedCohort(const CohortInputs& inputs);

/// Makes cohortReport(inputs) from analysedCohort(inputs). Throws as that.
[[nodiscard]] ReportModel cohortReport(const CohortInputs& inputs, const AnalysedCohort& analysed);

}  // namespace torsio
