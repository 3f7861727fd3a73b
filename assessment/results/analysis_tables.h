// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"
#include "assessment/results/study_analysis.h"

// Tables and figures of the section on agreement and comparisons. Private to assessment/results.
namespace torsio {

/// Returns "Group 1 - Group 2".
[[nodiscard]] Text pairName(const CohortInputs& inputs, std::size_t first, std::size_t second);
/// Returns the number of trainees with scores at both ends.
[[nodiscard]] std::int64_t comparedTrainees(const StudyAnalysis& study);

/// Returns the scores of a group at an occasion.
[[nodiscard]] std::vector<double> scoresOf(const CohortInputs& inputs, std::size_t group,
                                           std::size_t occasion);

[[nodiscard]] ReportTable agreementTable(const CohortInputs& inputs, const StudyAnalysis& study,
                                         const Ledger& ledger);
/// Returns agreement within each group, excluding differences between groups.
[[nodiscard]] ReportTable agreementWithinTable(const CohortInputs& inputs, const StudyAnalysis& study,
                                               const Ledger& ledger);
/// Returns pairwise agreement of raters, for marks in whole points.
[[nodiscard]] ReportTable kappaTable(const CohortInputs& inputs, const Ledger& ledger);
[[nodiscard]] std::optional<ReportFigure> agreementFigure(const CohortInputs& inputs, const Ledger& ledger);

/// Returns the mean of each group at each occasion with its interval.
[[nodiscard]] ReportTable meansTable(const CohortInputs& inputs, const Ledger& ledger);
[[nodiscard]] ReportTable covarianceTable(const CohortInputs& inputs, const StudyAnalysis& study,
                                          const Ledger& ledger);
/// Returns the differences with separate slopes per group; empty if the slopes do not differ.
[[nodiscard]] std::optional<ReportTable> slopesTable(const CohortInputs& inputs, const StudyAnalysis& study,
                                                     const Ledger& ledger);
/// Returns whether the differences of the primary comparison are within the planned margin; empty without a
/// margin.
[[nodiscard]] std::optional<ReportTable> equivalenceTable(const CohortInputs& inputs,
                                                          const StudyAnalysis& study, const Ledger& ledger);
/// Returns adjusted and standardised differences with intervals; empty if undefined.
[[nodiscard]] std::vector<ReportFigure> differenceFigures(const CohortInputs& inputs,
                                                          const StudyAnalysis& study, const Ledger& ledger);
/// Returns residuals against fitted values, and against normal quantiles.
[[nodiscard]] std::vector<ReportFigure> residualFigures(const CohortInputs& inputs,
                                                        const StudyAnalysis& study, const Ledger& ledger);

/// The raters' order of the models: Friedman's test of their own comprehensive scores.
struct ModelOrder {
  std::int64_t raters = 0;  ///< with a score for every model
  Outcome<Friedman> test = Outcome<Friedman>::undefined(Text::tr("not computed"));
  std::vector<double> meanRanks;  ///< by model; empty if the test is undefined
};
/// Returns the order of the models; empty for fewer than two.
[[nodiscard]] std::optional<ModelOrder> modelOrder(const CohortInputs& inputs);

/// How much higher the raters score one model than another: each rater's difference, by class weight.
struct ModelDifference {
  std::size_t first = 0;  ///< index in CohortInputs::evaluations
  std::size_t second = 0;
  std::int64_t raters = 0;  ///< with every mark of both
  Outcome<TTest> test = Outcome<TTest>::undefined(Text::tr("not computed"));
  double pHolm = 1.0;
  Interval asHolm;  ///< excludes 0 exactly if pHolm < 5 %
};
/// Returns every pair of models.
[[nodiscard]] std::vector<ModelDifference> modelDifferences(const CohortInputs& inputs);
/// Returns the key of a pair of models.
[[nodiscard]] ResultKey modelPairKey(const CohortInputs& inputs, const ModelDifference& pair);
[[nodiscard]] std::optional<ReportTable> modelDifferencesTable(const CohortInputs& inputs,
                                                               const Ledger& ledger);

/// Returns the codes of raters without a mark at this occasion who have marks at the other end of the study.
[[nodiscard]] std::vector<std::string> absentRaters(const StudyAnalysis& study, std::size_t occasion);
/// Returns the codes of raters who, at the last occasion, scored trainees of some of the groups only.
[[nodiscard]] std::vector<std::string> ratersOfSomeGroups(const CohortInputs& inputs);
/// Says whose severity cannot be told from an effect of the training; `codes`: of ratersOfSomeGroups().
[[nodiscard]] ReportParagraph ratersOfSomeGroupsSentence(const CohortInputs& inputs,
                                                         const std::vector<std::string>& codes,
                                                         const Ledger& ledger);
/// Returns the codes of trainees without any mark at one of the two ends.
[[nodiscard]] std::vector<std::string> leftOutTrainees(const StudyAnalysis& study);

/// Names groups without anybody scored at both ends; empty: all are compared.
[[nodiscard]] std::vector<Text> groupsNotCompared(const CohortInputs& inputs, const StudyAnalysis& study);
/// Describes which analysis was planned, which one is primary here, and who is excluded from what.
[[nodiscard]] std::vector<ReportParagraph> plannedAndUsed(const CohortInputs& inputs,
                                                          const StudyAnalysis& study, const Ledger& ledger);
/// Returns whose marks are missing; empty: none.
[[nodiscard]] std::optional<ReportTable> missingTable(const CohortInputs& inputs, const StudyAnalysis& study,
                                                      const Ledger& ledger);
/// Returns the comparison by the mixed model; empty if no mark is missing.
[[nodiscard]] std::optional<ReportTable> mixedModelTable(const CohortInputs& inputs,
                                                         const StudyAnalysis& study, const Ledger& ledger);
/// Returns how far missing marks could change each difference; empty if no mark is missing.
[[nodiscard]] std::optional<ReportTable> boundsTable(const CohortInputs& inputs, const StudyAnalysis& study,
                                                     const Ledger& ledger);

/// Tables of a pooled record of several centres; empty otherwise.
[[nodiscard]] std::optional<ReportTable> sitesTable(const CohortInputs& inputs, const StudyAnalysis& study,
                                                    const Ledger& ledger);
[[nodiscard]] std::optional<ReportTable> heterogeneityTable(const CohortInputs& inputs,
                                                            const StudyAnalysis& study, const Ledger& ledger);
[[nodiscard]] std::optional<ReportTable> siteDifferencesTable(const CohortInputs& inputs,
                                                              const StudyAnalysis& study,
                                                              const Ledger& ledger);
[[nodiscard]] std::optional<ReportTable> equipmentTable(const CohortInputs& inputs,
                                                        const StudyAnalysis& study, const Ledger& ledger);
[[nodiscard]] std::optional<ReportTable> siteFlowTable(const CohortInputs& inputs, const Ledger& ledger);
/// Says how the answer looks within the centres, and whether it varies between them.
[[nodiscard]] ReportParagraph sitesSentence(const CohortInputs& inputs, const StudyAnalysis& study,
                                            const Ledger& ledger);

}  // namespace torsio
