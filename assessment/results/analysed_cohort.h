// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"
#include "assessment/results/report_model.h"
#include "assessment/results/study_analysis.h"

namespace torsio {

/// Visible data of a cohort, their analysis and all results: computed once for both the results and the
/// report. The analysis takes seconds for 100,000 marks.
struct AnalysedCohort {
  CohortInputs shown;
  std::vector<Text> left;              ///< one sentence per omission
  std::optional<StudyAnalysis> study;  ///< empty if there are no marks
  Ledger ledger;                       ///< visible results
};

[[nodiscard]] AnalysedCohort analysedCohort(const CohortInputs& inputs);

/// Return the keys for the results of a run, of a trainee, and of inputs.competence[number].
[[nodiscard]] ResultKey trialKey(const Ledger& ledger, const TrialSummaryRow& trial);
[[nodiscard]] ResultKey traineeKey(const Ledger& ledger, const CohortTrainee& trainee);
/// Returns the name of the statistic "probability of being declared competent at a stated failure rate",
/// within the runs planned or made so far.
[[nodiscard]] std::string declaredStatistic(std::size_t rate, bool planned);
[[nodiscard]] ResultKey competenceKey(const Ledger& ledger, const CohortInputs& inputs, std::size_t number);

/// Builds cohortReport(inputs) from analysedCohort(inputs). Throws like the former.
[[nodiscard]] ReportModel cohortReport(const CohortInputs& inputs, const AnalysedCohort& analysed);

}  // namespace torsio
