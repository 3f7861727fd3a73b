// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"
#include "assessment/results/study_analysis.h"

// Parts of cohortReport(), one per source file.
namespace torsio {

/// The board's one-minute page; requires scores.
[[nodiscard]] ReportSection boardSection(const CohortInputs& inputs, const StudyAnalysis& study);
/// `all`: including hidden marks, of which only the counts of those scored are used.
[[nodiscard]] ReportSection participantsSection(const CohortInputs& inputs, const CohortInputs& all);
[[nodiscard]] ReportSection evaluationSection(const CohortInputs& inputs);
/// Describes what an evaluation lacks that cannot be computed yet, and each class's own result.
[[nodiscard]] ReportSection unfinishedSection(const CohortInputs& inputs);
/// Returns the raters with a sheet for any model: each should score all of them.
[[nodiscard]] std::set<std::string> evaluationRaters(const CohortInputs& inputs);
/// Counts the marks of a model.
[[nodiscard]] std::int64_t givenMarks(const ModelRatings& model);
/// Counts the missing marks of these raters over all models.
[[nodiscard]] std::int64_t missingEvaluationMarks(const CohortInputs& inputs);
/// Result of a single class of raters: Eq. 27 with its means of a model.
struct ClassScore {
  std::string model;
  std::size_t raterClass = 0;
  std::int64_t raters = 0;
  std::int64_t marks = 0;
  std::optional<double> score;  ///< points; empty if an index has no mark of this class
};
/// Returns the score of every class for every model.
[[nodiscard]] std::vector<ClassScore> classScores(const CohortInputs& inputs);
inline constexpr const char* kClassScoreStatistic = "class_score_eq27";

/// Returns the index of results for this number of raters.
[[nodiscard]] std::string ratersIndex(std::size_t raters);

[[nodiscard]] ReportSection trainingSection(const CohortInputs& inputs);
/// The scoring sheets with their anchors, and the marks per criterion.
[[nodiscard]] ReportSection criteriaSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection analysisSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection ratersSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection learningSection(const CohortInputs& inputs);
/// Who is competent, by which design and with which error rates.
[[nodiscard]] ReportSection competenceSection(const CohortInputs& inputs);
/// Deviations from the protocol.
[[nodiscard]] ReportSection deviationsSection(const CohortInputs& inputs);
/// Who signed which mark; requires signatures.
[[nodiscard]] ReportSection signaturesSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection trialsSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection methodsSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection provenanceSection(const CohortInputs& inputs);

/// Returns the effect of more or fewer raters, and each rater's severity on one scale.
[[nodiscard]] std::vector<ReportTable> reliabilityTables(const CohortInputs& inputs,
                                                         const StudyAnalysis& study);
/// Returns the gains within each group; empty if scores are missing.
[[nodiscard]] std::optional<ReportTable> withinGroupsTable(const CohortInputs& inputs,
                                                           const StudyAnalysis& study);

/// Returns the table of untwistings; empty if there are none.
[[nodiscard]] std::optional<ReportTable> detorsionTable(const CohortInputs& inputs);

/// Returns the flags of all figures and tables of a demonstration.
[[nodiscard]] std::vector<Text> commonFlags(const CohortInputs& inputs);

/// Starts a table or figure of the training study with id, title and provenance.
template <typename Item>
[[nodiscard]] Item itemOf(const CohortInputs& in, const std::string& id, const Text& title,
                          const Text& formula) {
  Item item;
  item.id = id;
  item.title = title;
  item.provenance.formula = formula;
  item.provenance.formulaVersion = kTrainingFormulaVersion;
  item.provenance.flags = commonFlags(in);
  return item;
}

}  // namespace torsio
