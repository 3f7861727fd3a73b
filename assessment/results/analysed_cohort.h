// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"
#include "assessment/results/report_model.h"
#include "assessment/results/study_analysis.h"

namespace torsio {

/// What may be seen of a cohort, its analysis and all its results: made once for whoever needs both the
/// results and the report. The analysis takes seconds for 100,000 marks.
struct AnalysedCohort {
  CohortInputs shown;
  std::vector<Text> left;              ///< one sentence for each thing that was left out
  std::optional<StudyAnalysis> study;  ///< empty without marks
  Ledger ledger;                       ///< what of the results may be seen
};

[[nodiscard]] AnalysedCohort analysedCohort(const CohortInputs& inputs);

/// Where the results of a run stand, and those of inputs.competence[number].
[[nodiscard]] ResultKey trialKey(const TrialSummaryRow& trial);
[[nodiscard]] ResultKey competenceKey(const CohortInputs& inputs, std::size_t number);

/// Makes cohortReport(inputs) from analysedCohort(inputs). Throws as that.
[[nodiscard]] ReportModel cohortReport(const CohortInputs& inputs, const AnalysedCohort& analysed);

}  // namespace torsio
