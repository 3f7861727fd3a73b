// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/competence.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/study_statement.h"
#include "assessment/results/report_model.h"
#include "assessment/scoring/evaluation.h"
#include "assessment/scoring/training_scores.h"

namespace torsio {

/// How people appear in a report. The numbers are the same; what may leave the centre differs.
enum class ReportIdentity {
  kCoded,       ///< pseudonyms
  kNamed,       ///< names added to the trainees' codes by the caller; raters stay coded
  kAggregated,  ///< no row about a single person, no count below kSmallestCell
};

/// Minimum number of people behind any statement of an aggregated report.
inline constexpr std::int64_t kSmallestCell = 5;

/// A trainee in the report: a code, and a name only if the caller added it.
struct CohortTrainee {
  std::string code;
  std::size_t group = 0;
  std::string sex;
  std::string level;
  bool withdrew = false;            ///< no longer takes part; recorded data stay
  std::int64_t enrolledUtc_us = 0;  ///< 0: unknown
  std::int64_t withdrewUtc_us = 0;  ///< when it was noted that they withdrew; 0: they did not, or unknown
  std::string site{};               ///< code of their centre in a pooled record; empty: this record's own
};

/// A group and its protocol.
struct CohortGroup {
  Text name;      ///< "Group 1"
  Text protocol;  ///< "40 min virtual"
  /// From the curriculum's arm; empty if the group follows none.
  std::optional<double> plannedVirtual_min{};
  std::optional<double> plannedReal_min{};
  std::string code{};
  std::string arm{};  ///< label of the arm in the curriculum
};

/// How trainees were allocated to groups.
struct CohortAllocation {
  Text method;
  std::string version;
  Text generator;
  std::uint64_t seed = 0;
  std::string commitment;
  bool replayed = false;                 ///< the allocation was replayed from the seed with the same result
  Facts design;                          ///< strata, block sizes ...
  bool sealed = false;                   ///< the seed is not revealed yet, so it is not printed
  bool replayDiffers = false;            ///< a replay found a difference
  std::int64_t lockedUtc_us = 0;         ///< time of the commitment; 0: unknown
  std::int64_t enrolledBeforeLock = 0;   ///< trainees enrolled at or before that time
  std::int64_t allocatedBeforeLock = 0;  ///< trainees allocated before that time
  std::int64_t movedByHand = 0;          ///< allocations overridden

  /// Returns whether, as far as the record knows, everybody is in the group that was drawn.
  [[nodiscard]] bool asDrawn() const noexcept {
    return !method.empty() && movedByHand == 0 && !replayDiffers;
  }
};

/// The frozen data set that the report is made from.
struct CohortFreeze {
  std::string name;
  std::string contentHash;
  std::int64_t frozenUtc_us = 0;
  std::string frozenBy;
  bool unchanged = true;         ///< the current data still have that hash
  std::int64_t sheetsAsked = 0;  ///< of raters, when it was frozen; 0: not known
  std::int64_t sheetsSubmitted = 0;
  std::string whyIncomplete{};
  std::string askedBy{};  ///< of an interim state: the other person who asked for it; empty: nobody did
  [[nodiscard]] bool interim() const noexcept { return sheetsSubmitted < sheetsAsked; }
};

/// Where a cohort came from that was not made in this record.
struct CohortOrigin {
  std::string layout;  ///< "Torsio", "JIGSAWS"
  std::string source;  ///< as the data name it
  std::string contentHash;
  std::string importedBy;  ///< sign-in name, or id
  std::int64_t importedUtc_us = 0;
  std::vector<std::string> earlier{};  ///< where the source had it from, oldest first
  std::string signedBy{};              ///< public key whose signature was checked; empty: unsigned
  std::int64_t marks = 0;              ///< that came with it
  std::int64_t recordings = 0;
};

/// A deviation from the protocol.
struct CohortDeviation {
  std::int64_t happenedUtc_us = 0;
  std::string trainee;  ///< empty: whole cohort
  std::string kind;
  std::string description;
  DeviationId id{};
};

/// Numbers of marks of the training study by the way they were made.
struct MarkWays {
  std::int64_t blinded = 0;  ///< on a recording under a case label, with a sheet of the review desk
  std::int64_t live = 0;     ///< with a sheet at the real arm
  std::int64_t entered = 0;  ///< without a sheet
};

/// A trainee's recorded time for training and rest.
struct CohortDose {
  std::string trainee;
  double virtual_min = 0.0;
  double real_min = 0.0;
  double rest_min = 0.0;
};

/// Summary of one recorded trial.
struct TrialSummaryRow {
  TrialId trialId;
  std::string trainee;
  std::size_t group = 0;
  Text phase;  ///< "virtual 0-20 min"
  std::string model;
  double minutes = 0.0;
  std::int64_t samples = 0;
  std::int64_t twists = 0;            ///< completed: assessment/attempt/recorded_twists.h
  std::int64_t twistsOnTarget = 0;    ///< released within the tolerance
  std::int64_t unfinishedTwists = 0;  ///< cut off by the end, a fault or missing samples; not included in
                                      ///< `twists`
  std::optional<double> meanAbsoluteError_deg;  ///< difference between angle at release and target
  std::optional<double> peakTorque_Nm;
  std::optional<double> peakForce_N;        ///< on the tissue
  std::optional<double> peakDeviceForce_N;  ///< sent to the device
  std::int64_t refusedSamples = 0;
  std::int64_t lateTicks = 0;
  std::int64_t forceCuts = 0;  ///< pauses of the servo that briefly interrupted the force
  bool interrupted = false;
  RunOutcome outcome = RunOutcome::kRefused;  ///< of its verdict (assessment/attempt/run_verdict.h)
  std::string contentHash;
  std::string device{};               ///< model of the haptic device, as the recording names it
  std::string station{};              ///< the recording machine
  std::vector<JudgedTwist> attempts;  ///< completed twists in order
  /// Defined metrics of an untwisting by id; empty for an exercise with twists.
  std::map<std::string, double> detorsion{};
};

/// The verdict on a trainee at an exercise, the same everywhere (app/services/recording/competence.h).
struct CohortCompetence {
  std::string trainee;
  std::size_t group = 0;
  Text exercise;
  std::int64_t attempts = 0;
  std::int64_t failed = 0;
  Text level;  ///< as text
  bool able = false;
  std::optional<std::int64_t> ableAt{};  ///< first attempt that showed competence
  std::vector<double> sums{};            ///< one per attempt: LC-CUSUM until competent, then the relapse
                                         ///< watch
  double limit = 1.0;
  double falsePass = 0.0;
  double falseFail = 0.0;
  double falseAlarm = 0.0;                                                 ///< all three within the runs made
  std::array<double, kStatedFailureRates.size()> declaredWithinMade{};     ///< by stated failure rate
  std::array<double, kStatedFailureRates.size()> declaredWithinPlanned{};  ///< by stated failure rate
  std::int64_t plannedAttempts = 0;
  std::int64_t fewestAttempts = 0;  ///< with fewer nobody can be declared competent
  bool required = true;             ///< by the curriculum, for being competent altogether

  /// Returns whether there are enough runs for a verdict.
  [[nodiscard]] bool shown() const noexcept { return attempts >= fewestAttempts; }
  std::int64_t designVersion = 0;  ///< 0: shipped with the exercise
  Text design;                     ///< as text
  Text errors;                     ///< the rates as text, within the runs planned
  std::vector<TrialId> runs{};     ///< the attempts, oldest first
  std::vector<TrialId> excused{};  ///< interrupted runs that do not count, oldest first
};

/// A rater's signature of one mark.
struct CohortSignature {
  std::string signer{};  ///< code, or code and name
  std::string trainee{};
  Text occasion{};
  std::int64_t version = 1;
  Text meaning{};
  std::string reason{};
  std::int64_t signedUtc_us = 0;
};

/// Meaning of a mark of a criterion, as text.
struct ReportedAnchor {
  double points = 0.0;
  std::string meaning{};
};

/// A row of a scoring sheet as seen by raters.
struct ReportedCriterion {
  std::string code{};  ///< "proficiency"
  std::string label{};
  double lowest = 0.0;  ///< points
  double highest = 0.0;
  double weight = 1.0;  ///< in the mean of the criteria
  std::vector<ReportedAnchor> anchors{};
};

/// A revision of a scoring sheet used by raters.
struct ReportedSheet {
  std::string name{};
  std::int64_t revision = 1;
  std::vector<ReportedCriterion> criteria{};
  RubricRevisionId id{};
};

/// A rater's mark for one criterion.
struct CriterionMark {
  std::string trainee{};
  std::string rater{};
  std::size_t group = 0;
  std::size_t occasion = 0;
  std::size_t sheet = 0;           ///< index in CohortInputs::sheets
  std::size_t criterion = 0;       ///< index in the sheet
  std::optional<double> points{};  ///< empty: not assessable
  MarkId mark{};                   ///< the mark that it belongs to
};

/// Indices of a model that no rater of a class has scored.
struct UnscoredIndices {
  std::string raterClass{};            ///< name
  std::string model{};                 ///< code
  std::vector<std::string> indices{};  ///< names
};

/// An evaluation that cannot be computed yet.
struct UnfinishedEvaluation {
  std::int64_t marks = 0;                   ///< number so far
  std::vector<std::string> classesMissing;  ///< names of weighted classes that have not scored everything
  std::vector<UnscoredIndices> unscored{};  ///< by these classes, in order of classes and models
};

/// Input of a cohort report.
struct CohortInputs {
  Text title = Text::tr("Cohort report");
  std::string centre;
  std::string softwareVersion;
  std::string programHash;  ///< BLAKE2b-256 of the program file; empty: unknown
  std::int64_t createdUtc_us = 0;
  std::int64_t auditEntries = 0;  ///< length of the audit trail at that time
  std::string auditHead;          ///< hash of its latest entry; empty: no entries
  bool demonstration = false;
  std::optional<CohortOrigin> imported;  ///< empty: made in this record
  std::vector<std::string> sites;  ///< codes of the centres whose data were pooled; empty: one centre's own
  std::vector<Text> simulated;     ///< which data are simulated, and by which rule
  Facts facts;                     ///< additional lines of the cover
  std::int64_t trainingTimeDivisor = 1;  ///< 60: one simulated minute represents one hour of training
  std::int64_t rests = 0;                ///< number of trainees who took a rest
  ReportIdentity identity = ReportIdentity::kCoded;
  std::optional<CohortFreeze> freeze;  ///< empty: current data
  std::int64_t notAllocated = 0;       ///< enrolled but not in a group
  /// Planned: smaller differences, in points, are irrelevant; above 0. Empty: none planned.
  std::optional<double> equivalenceMargin;
  /// Returns whether the record states how the groups were to be compared: the margin is set with the cohort.
  /// A study that was imported brings its margin, but nothing shows when it was set.
  [[nodiscard]] bool hasAnalysisPlan() const noexcept { return equivalenceMargin && !imported; }

  StudyStatements statements;  ///< what the study says about itself

  std::vector<CohortGroup> groups;
  std::vector<CohortTrainee> trainees;
  CohortAllocation allocation;

  EvaluationInstrument instrument;
  EvaluationPolicy evaluationPolicy;
  std::vector<ModelRatings> ratings;         ///< in the report's order of models
  std::vector<ModelEvaluation> evaluations;  ///< same order; empty while the evaluation is unfinished
  std::size_t chiefClass = 2;                ///< class of Fig. 18
  std::optional<UnfinishedEvaluation> unfinishedEvaluation;  ///< instead of these two

  ScoreScale trainingScale{10, 100, 10};
  std::vector<Text> occasions;  ///< "before", "after 20 min", "after 40 min"
  std::vector<TraineeScore> scores;
  std::vector<GroupSummary> summaries;
  std::size_t trainingRaters = 0;
  /// The marks behind the scores. If given, the report has a section on agreement and comparisons.
  std::vector<TrainingMark> trainingMarks;
  /// The sheets behind these marks, with marks of the criteria; empty: entered without a sheet.
  std::vector<ReportedSheet> sheets;
  std::vector<CriterionMark> criterionMarks;
  /// Whether the reader may see single marks; scores, agreement and severity are always shown.
  bool singleMarks = true;

  MarkWays markWays;
  std::int64_t sheetsAsked = 0;            ///< of raters for this cohort
  std::int64_t sheetsPresent = 0;          ///< of these, submitted
  std::int64_t evaluationRatersAsked = 0;  ///< raters of the campaign; 0: unknown
  std::int64_t modelsHidden = 0;           ///< evaluated models shown to their raters under a hidden label

  std::int64_t notAssessable = 0;  ///< answers "not assessable" with a reason
  std::vector<CohortDose> doses;
  std::vector<CohortDeviation> deviations;
  std::vector<CohortSignature> signatures;  ///< of the marks that were signed
  std::int64_t unsignedMarks = 0;           ///< number of the others

  std::vector<TrialSummaryRow> trials;
  std::vector<CohortCompetence> competence;
  Facts provenance;  ///< organ hash, parameter hash, database schema ...
};

/// Builds the cohort report as plain values (paper sections 5.3 and 6: Figs. 15 to 23). The same inputs give
/// the same report. Throws Error{kBadData} if lists that belong together differ in length.
[[nodiscard]] ReportModel cohortReport(const CohortInputs& inputs);

}  // namespace torsio
