// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/study_analysis.h"

// Tables and figures of the section about agreement and comparisons. Private to assessment/results.
namespace torsio {

/// Returns "Group 1 - Group 2".
[[nodiscard]] Text pairName(const CohortInputs& inputs, std::size_t first, std::size_t second);
/// Returns how many trainees have a score at both ends.
[[nodiscard]] std::int64_t comparedTrainees(const StudyAnalysis& study);

/// Returns the scores of a group at an occasion.
[[nodiscard]] std::vector<double> scoresOf(const CohortInputs& inputs, std::size_t group,
                                           std::size_t occasion);

[[nodiscard]] ReportTable agreementTable(const CohortInputs& inputs, const StudyAnalysis& study);
/// Returns agreement within each group: what is left when differences between the groups do not count.
[[nodiscard]] ReportTable agreementWithinTable(const CohortInputs& inputs, const StudyAnalysis& study);
/// Returns agreement of the pairs of raters where marks are taken in whole points.
[[nodiscard]] ReportTable kappaTable(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] std::optional<ReportFigure> agreementFigure(const CohortInputs& inputs,
                                                          const StudyAnalysis& study);

/// Returns the mean of each group at each occasion with its interval.
[[nodiscard]] ReportTable meansTable(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportTable covarianceTable(const CohortInputs& inputs, const StudyAnalysis& study);
/// Returns what the differences are when each group has a slope of its own; empty where slopes do not differ.
[[nodiscard]] std::optional<ReportTable> slopesTable(const CohortInputs& inputs, const StudyAnalysis& study);
/// Returns whether the differences of the primary comparison lie within the margin of the plan; empty where
/// none was planned.
[[nodiscard]] std::optional<ReportTable> equivalenceTable(const CohortInputs& inputs,
                                                          const StudyAnalysis& study);
/// Returns adjusted and standardised differences with intervals; none when they are not defined.
[[nodiscard]] std::vector<ReportFigure> differenceFigures(const CohortInputs& inputs,
                                                          const StudyAnalysis& study);
/// Returns residuals against what the model says, and against normal quantiles.
[[nodiscard]] std::vector<ReportFigure> residualFigures(const CohortInputs& inputs,
                                                        const StudyAnalysis& study);

/// How the raters order the models: Friedman's test of their own comprehensive scores.
struct ModelOrder {
  std::int64_t raters = 0;  ///< with a score for every model
  Outcome<Friedman> test = Outcome<Friedman>::undefined(Text::tr("not computed"));
  std::vector<double> meanRanks;  ///< by model; empty where the test is not defined
};
/// Returns the order of the models; empty with fewer than two of them.
[[nodiscard]] std::optional<ModelOrder> modelOrder(const CohortInputs& inputs);

/// Names the groups of which nobody has a score at both ends, "Group 3 (n = 0)"; none: all are compared.
[[nodiscard]] std::vector<Text> groupsNotCompared(const CohortInputs& inputs, const StudyAnalysis& study);
/// Says which raters scored some groups only; empty: nobody did.
[[nodiscard]] std::vector<Text> raterGroupSentences(const CohortInputs& inputs, const StudyAnalysis& study);
/// Says which analysis was planned, which one is primary here, and who is left out of what.
[[nodiscard]] std::vector<Text> plannedAndUsed(const CohortInputs& inputs, const StudyAnalysis& study);
/// Returns whose marks are missing; empty: nobody's.
[[nodiscard]] std::optional<ReportTable> missingTable(const CohortInputs& inputs, const StudyAnalysis& study);
/// Returns the comparison by the mixed model; empty where no mark is missing.
[[nodiscard]] std::optional<ReportTable> mixedModelTable(const CohortInputs& inputs,
                                                         const StudyAnalysis& study);
/// Returns how far missing marks could move each difference; empty where no mark is missing.
[[nodiscard]] std::optional<ReportTable> boundsTable(const CohortInputs& inputs, const StudyAnalysis& study);

}  // namespace torsio
