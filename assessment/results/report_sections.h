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

// Parts of cohortReport(), one a source file.
namespace torsio {

/// The page that a board reads in a minute; there are scores.
[[nodiscard]] ReportSection boardSection(const CohortInputs& inputs, const StudyAnalysis& study);
/// `all`: with what is not shown of the marks; nothing of it but who was scored enters.
[[nodiscard]] ReportSection participantsSection(const CohortInputs& inputs, const CohortInputs& all);
[[nodiscard]] ReportSection evaluationSection(const CohortInputs& inputs);
/// Says of an evaluation that cannot be computed yet what it lacks, and what each class gives by itself.
[[nodiscard]] ReportSection unfinishedSection(const CohortInputs& inputs);
/// Returns the raters with a sheet for any model: each was to score all of them.
[[nodiscard]] std::set<std::string> evaluationRaters(const CohortInputs& inputs);
/// Counts the marks that a model was given.
[[nodiscard]] std::int64_t givenMarks(const ModelRatings& model);
/// Counts the marks of these raters that are missing, over all models.
[[nodiscard]] std::int64_t missingEvaluationMarks(const CohortInputs& inputs);
/// A class of raters by itself: Eq. 27 on its means of a model.
struct ClassScore {
  std::string model;
  std::size_t raterClass = 0;
  std::int64_t raters = 0;
  std::int64_t marks = 0;
  std::optional<double> score;  ///< points; empty: an index has no mark of this class
};
/// Returns the score of every class for every model.
[[nodiscard]] std::vector<ClassScore> classScores(const CohortInputs& inputs);
inline constexpr const char* kClassScoreStatistic = "class_score_eq27";

/// Index of what so many raters would give.
[[nodiscard]] std::string ratersIndex(std::size_t raters);

[[nodiscard]] ReportSection trainingSection(const CohortInputs& inputs);
/// The scoring sheets with their anchors, and what was given for each criterion.
[[nodiscard]] ReportSection criteriaSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection analysisSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection ratersSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection learningSection(const CohortInputs& inputs);
/// Who is held to be able, by which design and with which errors.
[[nodiscard]] ReportSection competenceSection(const CohortInputs& inputs);
/// What did not go by the protocol.
[[nodiscard]] ReportSection deviationsSection(const CohortInputs& inputs);
/// Who signed which mark; some were.
[[nodiscard]] ReportSection signaturesSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection trialsSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection methodsSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection provenanceSection(const CohortInputs& inputs);

/// Returns what more or fewer raters would give, and each rater's severity on one scale.
[[nodiscard]] std::vector<ReportTable> reliabilityTables(const CohortInputs& inputs,
                                                         const StudyAnalysis& study);
/// Returns what each group gained by itself; empty: scores are missing.
[[nodiscard]] std::optional<ReportTable> withinGroupsTable(const CohortInputs& inputs,
                                                           const StudyAnalysis& study);

/// Returns the table of the trials in which an organ was undone; empty: there are none.
[[nodiscard]] std::optional<ReportTable> detorsionTable(const CohortInputs& inputs);

/// Returns the flags that every figure and table of a demonstration carries.
[[nodiscard]] std::vector<Text> commonFlags(const CohortInputs& inputs);

/// Begins a table or figure of the training study: its id, its title and where its numbers come from.
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
