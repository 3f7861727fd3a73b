// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"
#include "assessment/results/study_analysis.h"

// Statements of the report about the study, computed from the record.
namespace torsio {

/// States whether raters of the training study were blinded, from how each mark was made. Requires marks.
[[nodiscard]] ReportParagraph markWaysSentence(const CohortInputs& inputs, const Ledger& ledger);
/// The same with what the record knows of the raters of the models.
[[nodiscard]] std::vector<ReportParagraph> blindingSentences(const CohortInputs& inputs,
                                                             const Ledger& ledger);
/// Returns the decimals needed to distinguish the ends of an interval of points from each other, and from
/// zero if it excludes zero.
[[nodiscard]] int decimalsOf(const Interval& interval);
/// States which difference the comparison detects, and what it cannot show.
[[nodiscard]] ReportParagraph detectableSentence(const StudyAnalysis& study, const Ledger& ledger);
/// States that the cohort is simulated, or imported from where; empty: neither.
[[nodiscard]] std::vector<Text> originSentences(const CohortInputs& inputs);
/// States where the cohort came from, by whom and when.
[[nodiscard]] Text importSentence(const CohortOrigin& origin);
/// States when the seed was committed, relative to enrolment and allocation.
[[nodiscard]] ReportParagraph commitmentSentence(const CohortAllocation& allocation, const Ledger& ledger);
/// States whether the allocation was replayed from its seed, and the result.
[[nodiscard]] Text replaySentence(const CohortAllocation& allocation);
/// States how many of the possible marks exist.
[[nodiscard]] ReportParagraph marksSentence(const CohortInputs& inputs, const Ledger& ledger);

/// Returns whether every trainee has a mark by every rater at every occasion.
[[nodiscard]] bool allMarksGiven(const CohortInputs& inputs);

}  // namespace torsio
