// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "assessment/report/cohort_report.h"
#include "assessment/report/study_analysis.h"

// Parts of cohortReport(), one a source file.
namespace torsio {

/// The page that a board reads in a minute; there are scores.
[[nodiscard]] ReportSection boardSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection participantsSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection evaluationSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection trainingSection(const CohortInputs& inputs);
/// The scoring sheets with their anchors, and what was given for each criterion.
[[nodiscard]] ReportSection criteriaSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection analysisSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection ratersSection(const CohortInputs& inputs, const StudyAnalysis& study);
[[nodiscard]] ReportSection learningSection(const CohortInputs& inputs);
/// Who is held to be able, by which design and with which errors.
[[nodiscard]] ReportSection competenceSection(const CohortInputs& inputs);
[[nodiscard]] ReportSection deviationsSection(const CohortInputs& inputs);
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
