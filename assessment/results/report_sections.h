// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"
#include "assessment/results/study_analysis.h"

// Parts of cohortReport(), one per source file.
namespace torsio {

/// Decimals of points in sentences.
inline constexpr int kPointDecimals = 1;

/// Returns the index of the last occasion; requires one.
[[nodiscard]] inline std::size_t lastOf(const CohortInputs& inputs) {
  return inputs.occasions.size() - 1;
}

/// The board's one-minute page; requires scores.
[[nodiscard]] ReportSection boardSection(const CohortInputs& inputs, const StudyAnalysis& study,
                                         const Ledger& ledger);
/// Returns what stands against the answer on that page, or limits it: doubts about the data, what else could
/// explain a difference, missing data, the analysis.
[[nodiscard]] std::vector<ReportParagraph> reservations(const CohortInputs& inputs,
                                                        const StudyAnalysis& study, const Ledger& ledger);
[[nodiscard]] ReportSection participantsSection(const CohortInputs& inputs, const Ledger& ledger);
[[nodiscard]] ReportSection evaluationSection(const CohortInputs& inputs, const Ledger& ledger);
/// Describes what an evaluation lacks that cannot be computed yet, and each class's own result.
[[nodiscard]] ReportSection unfinishedSection(const CohortInputs& inputs, const Ledger& ledger);
/// Returns the raters with a sheet for any model: each should score all of them.
[[nodiscard]] std::set<std::string> evaluationRaters(const CohortInputs& inputs);
/// Counts the marks of a model.
[[nodiscard]] std::int64_t givenMarks(const ModelRatings& model);
/// Count the missing marks of these raters for a model, and over all models.
[[nodiscard]] std::int64_t missingEvaluationMarks(const CohortInputs& inputs, const ModelRatings& model);
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

/// All twists of a trainee in the order of recording.
struct PracticeCourse {
  std::string trainee;
  std::size_t group = 0;
  std::vector<JudgedTwist> attempts;
};
/// Returns the trainees with twists by group and code.
[[nodiscard]] std::vector<PracticeCourse> practiceCourses(const CohortInputs& inputs);
/// The marks or recordings behind a part of the report.
struct MarksHash {
  std::int64_t count = 0;
  std::string hash;  ///< BLAKE2b-256
};
[[nodiscard]] MarksHash hashOfEvaluationMarks(const CohortInputs& inputs);
[[nodiscard]] MarksHash hashOfTrainingMarks(const CohortInputs& inputs);
[[nodiscard]] MarksHash hashOfTrials(const CohortInputs& inputs);
inline constexpr const char* kEvaluationMarks = "evaluation_marks";
inline constexpr const char* kTrainingMarks = "training_marks";
inline constexpr const char* kRecordings = "recordings";
inline constexpr const char* kTrainingTimes = "training_times";
/// Results about one of these as a whole.
[[nodiscard]] inline ResultKey wholeKey(const char* source) {
  return {.section = ResultSection::kRecord, .of = source};
}

/// Quantities of a recording of other equipment.
inline constexpr std::array kForeignQuantities{Quantity::kTime, Quantity::kTipPath, Quantity::kIdleTime};
/// How long the instrument was out of view in the runs of a group and phase, and its share of their time.
inline constexpr const char* kTimeOutOfView = "total_view.lost";
inline constexpr const char* kShareOutOfView = "total_view.lost_share";
/// Returns the key for a trainee's course of such a quantity.
[[nodiscard]] ResultKey foreignKey(const Ledger& ledger, const std::string& trainee, std::size_t group,
                                   const std::string& metric);
inline constexpr const char* kRegripsBeyondLeast = "regrips_beyond_least";
/// Returns tables on recordings of other equipment: medians by group and phase, and each trainee's course
/// over the recordings. Empty if there are none.
[[nodiscard]] std::vector<ReportTable> foreignTables(const CohortInputs& inputs, const Ledger& ledger);

/// Runs of a group in a phase, oldest first, and the key of their results.
struct PhaseRuns {
  std::size_t group = 0;
  ResultKey place;
  std::vector<const TrialSummaryRow*> runs;  ///< never empty
};
/// Returns the runs with twists, the untwistings, the recordings of other equipment: in the order of groups.
enum class RunKind : std::uint8_t { kTwists, kUntwisting, kForeign };
/// Returns the key for how many runs of this kind there are.
[[nodiscard]] ResultKey runsKey(RunKind kind);
[[nodiscard]] std::vector<PhaseRuns> runsByPhase(const CohortInputs& inputs, const Ledger& ledger,
                                                 RunKind kind);

/// Returns the index of results for this number of raters.
[[nodiscard]] std::string ratersIndex(std::size_t raters);
/// Returns the key, without groups and occasion, of differences at a score before.
[[nodiscard]] ResultKey slopesKey(const StudyAnalysis& study, std::size_t baseline);
/// A mark of the last occasion and the mean of the other raters' marks of the trainee: half their sum, and
/// the first less the second.
inline constexpr const char* kMarkAndOthers = "mean_of_mark_and_others";
inline constexpr const char* kMarkMinusOthers = "mark_minus_others";

[[nodiscard]] ReportSection trainingSection(const CohortInputs& inputs, const Ledger& ledger);
/// The scoring sheets with their anchors, and the marks per criterion.
[[nodiscard]] ReportSection criteriaSection(const CohortInputs& inputs, const Ledger& ledger);
[[nodiscard]] ReportSection analysisSection(const CohortInputs& inputs, const StudyAnalysis& study,
                                            const Ledger& ledger);
[[nodiscard]] ReportSection ratersSection(const CohortInputs& inputs, const StudyAnalysis& study,
                                          const Ledger& ledger);
[[nodiscard]] ReportSection learningSection(const CohortInputs& inputs, const Ledger& ledger);
/// Who is competent, by which design and with which error rates.
[[nodiscard]] ReportSection competenceSection(const CohortInputs& inputs, const Ledger& ledger);
/// Deviations from the protocol.
[[nodiscard]] ReportSection deviationsSection(const CohortInputs& inputs, const Ledger& ledger);
/// Returns the key for inputs.deviations[number].
[[nodiscard]] ResultKey deviationKey(const CohortInputs& inputs, std::size_t number);
/// Who signed which mark; requires signatures.
[[nodiscard]] ReportSection signaturesSection(const CohortInputs& inputs, const Ledger& ledger);
[[nodiscard]] ReportSection trialsSection(const CohortInputs& inputs, const Ledger& ledger);
[[nodiscard]] ReportSection methodsSection(const CohortInputs& inputs, const StudyAnalysis& study,
                                           const Ledger& ledger);
[[nodiscard]] ReportSection provenanceSection(const CohortInputs& inputs, const Ledger& ledger);
/// Returns what the study says about itself.
[[nodiscard]] ReportSection statementsSection(const CohortInputs& inputs);
/// Returns checklists of what a report should contain and where `report` has it; call with all other
/// sections.
[[nodiscard]] ReportSection checklistSection(const CohortInputs& inputs, const ReportModel& report);

/// Returns the effect of more or fewer raters, and each rater's severity on one scale.
[[nodiscard]] std::vector<ReportTable> reliabilityTables(const CohortInputs& inputs,
                                                         const StudyAnalysis& study, const Ledger& ledger);
/// Returns the gains within each group; empty if scores are missing.
[[nodiscard]] std::optional<ReportTable> withinGroupsTable(const CohortInputs& inputs,
                                                           const StudyAnalysis& study, const Ledger& ledger);

/// Returns the table of untwistings; empty if there are none.
[[nodiscard]] std::optional<ReportTable> detorsionTable(const CohortInputs& inputs, const Ledger& ledger);

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
