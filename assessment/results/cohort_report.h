// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/results/report_model.h"
#include "assessment/scoring/evaluation.h"
#include "assessment/scoring/training_scores.h"

namespace torsio {

/// How people appear in a report. The numbers are the same; what may leave the centre differs.
enum class ReportIdentity {
  kCoded,       ///< pseudonyms
  kNamed,       ///< the caller has put names beside the codes of the trainees; raters stay coded
  kAggregated,  ///< no line about a single person, no count of fewer than kSmallestCell
};

/// Fewest people about whom an aggregated report says anything.
inline constexpr std::int64_t kSmallestCell = 5;

/// A trainee as the report shows one: a code, and a name only where the caller put it there.
struct CohortTrainee {
  std::string code;
  std::size_t group = 0;
  std::string sex;
  std::string level;
  bool withdrew = false;            ///< takes part no more; what was recorded stays
  std::int64_t enrolledUtc_us = 0;  ///< 0: not known
};

/// A group and what it does.
struct CohortGroup {
  Text name;      ///< "Group 1"
  Text protocol;  ///< "40 min virtual"
  /// Of the curriculum's arm; empty: the group follows none.
  std::optional<double> plannedVirtual_min{};
  std::optional<double> plannedReal_min{};
  std::string code{};
  std::string arm{};  ///< label of the curriculum's arm
};

/// How trainees came into their groups.
struct CohortAllocation {
  Text method;
  std::string version;
  Text generator;
  std::uint64_t seed = 0;
  std::string commitment;
  bool replayed = false;                 ///< the sequence was repeated from the seed and found the same
  Facts design;                          ///< strata, block sizes ...
  bool sealed = false;                   ///< the seed has not been revealed yet and is not printed
  bool replayDiffers = false;            ///< it was repeated, and something was found to differ
  std::int64_t lockedUtc_us = 0;         ///< when the commitment was made; 0: not known
  std::int64_t enrolledBeforeLock = 0;   ///< trainees enrolled at that time or before
  std::int64_t allocatedBeforeLock = 0;  ///< trainees allocated before that time
  std::int64_t movedByHand = 0;          ///< allocations that are not as drawn
};

/// The named state of the data that the report is made from.
struct CohortFreeze {
  std::string name;
  std::string contentHash;
  std::int64_t frozenUtc_us = 0;
  std::string frozenBy;
  bool unchanged = true;  ///< the data of today still have that hash
};

/// Something that did not go by the protocol.
struct CohortDeviation {
  std::int64_t happenedUtc_us = 0;
  std::string trainee;  ///< empty: the whole cohort
  std::string kind;
  std::string description;
  DeviationId id{};
};

/// How the marks of the training study were given, counted.
struct MarkWays {
  std::int64_t blinded = 0;  ///< on a recording under a case label, by a sheet of the desk
  std::int64_t live = 0;     ///< by a sheet at the real arm
  std::int64_t entered = 0;  ///< without any sheet
};

/// What a trainee spent training and resting, as it was noted.
struct CohortDose {
  std::string trainee;
  double virtual_min = 0.0;
  double real_min = 0.0;
  double rest_min = 0.0;
};

/// One twist of a recorded trial, in its order.
struct TwistAttempt {
  double error_deg = 0.0;  ///< absolute, of the angle at letting go against the target in force
  bool onTarget = false;
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
  std::int64_t twistsOnTarget = 0;    ///< let go within the tolerance
  std::int64_t unfinishedTwists = 0;  ///< cut off by the end, a fault or missing samples: not in `twists`
  std::optional<double> meanAbsoluteError_deg;  ///< of the angle at letting go against the target in force
  std::optional<double> peakTorque_Nm;
  std::optional<double> peakForce_N;        ///< on the tissue
  std::optional<double> peakDeviceForce_N;  ///< that the device was told to give
  std::int64_t refusedSamples = 0;
  std::int64_t lateTicks = 0;
  std::int64_t forceCuts = 0;  ///< pauses of the servo after which there was no force for a moment
  bool interrupted = false;
  std::string contentHash;
  std::vector<TwistAttempt> attempts;
  /// Metrics of an untwisting by id, those that are defined; empty: an exercise of twisting.
  std::map<std::string, double> detorsion{};
};

/// The verdict about one trainee at one exercise, as every other place shows it (app/recording/competence.h).
struct CohortCompetence {
  std::string trainee;
  std::size_t group = 0;
  Text exercise;
  std::int64_t attempts = 0;
  std::int64_t failed = 0;
  Text level;  ///< in words
  bool able = false;
  std::optional<std::int64_t> ableAt{};  ///< number of the attempt that first showed it
  std::vector<double> sums{};            ///< one an attempt: LC-CUSUM until able, the relapse watch after
  double limit = 1.0;
  double falsePass = 0.0;
  double falseFail = 0.0;
  double falseAlarm = 0.0;
  std::int64_t withinAttempts = 0;  ///< to which these rates belong
  std::int64_t designVersion = 0;   ///< 0: the design shipped with the exercise
  Text design;                      ///< in words
  Text errors;                      ///< these rates in words, within the attempts of the design
  std::vector<TrialId> runs{};      ///< the attempts, oldest first
};

/// What a rater said by signing one mark.
struct CohortSignature {
  std::string signer{};  ///< code, or code and name
  std::string trainee{};
  Text occasion{};
  std::int64_t version = 1;
  Text meaning{};
  std::string reason{};
  std::int64_t signedUtc_us = 0;
};

/// What a mark of a criterion means, in words.
struct ReportedAnchor {
  double points = 0.0;
  std::string meaning{};
};

/// A line of a scoring sheet as raters saw it.
struct ReportedCriterion {
  std::string code{};  ///< "proficiency"
  std::string label{};
  double lowest = 0.0;  ///< points
  double highest = 0.0;
  double weight = 1.0;  ///< in the mean of the criteria
  std::vector<ReportedAnchor> anchors{};
};

/// A revision of a scoring sheet that raters filled in.
struct ReportedSheet {
  std::string name{};
  std::int64_t revision = 1;
  std::vector<ReportedCriterion> criteria{};
  RubricRevisionId id{};
};

/// What one rater gave for one criterion.
struct CriterionMark {
  std::string trainee{};
  std::string rater{};
  std::size_t group = 0;
  std::size_t occasion = 0;
  std::size_t sheet = 0;           ///< of CohortInputs::sheets
  std::size_t criterion = 0;       ///< of the sheet
  std::optional<double> points{};  ///< empty: not assessable
  MarkId mark{};                   ///< of which it is a part
};

/// Indices of a model that nobody of a class of raters scored.
struct UnscoredIndices {
  std::string raterClass{};            ///< name
  std::string model{};                 ///< code
  std::vector<std::string> indices{};  ///< names
};

/// An evaluation that cannot be computed yet.
struct UnfinishedEvaluation {
  std::int64_t marks = 0;                   ///< so far
  std::vector<std::string> classesMissing;  ///< names of the weighted classes that have not scored everything
  std::vector<UnscoredIndices> unscored{};  ///< by these classes, in the order of classes and models
};

/// Everything a cohort report is made from.
struct CohortInputs {
  Text title = Text::tr("Cohort report");
  std::string centre;
  std::string softwareVersion;
  std::string programHash;  ///< BLAKE2b-256 of the program file; empty: not known
  std::int64_t createdUtc_us = 0;
  std::int64_t auditEntries = 0;  ///< length of the audit trail then
  std::string auditHead;          ///< hash of its newest entry; empty: nothing was noted yet
  bool demonstration = false;
  std::vector<Text> simulated;           ///< what of this is simulated and by which rule
  Facts facts;                           ///< further lines for the cover
  std::int64_t trainingTimeDivisor = 1;  ///< 60: one simulated minute stands for one hour of training
  std::int64_t rests = 0;                ///< trainees who took a rest
  ReportIdentity identity = ReportIdentity::kCoded;
  std::optional<CohortFreeze> freeze;  ///< empty: the data as they are now
  std::int64_t notAllocated = 0;       ///< enrolled, but in no group
  /// Planned: smaller differences, in points, do not matter; above 0. Empty: none was planned.
  std::optional<double> equivalenceMargin;
  /// Whether the record says how the groups were to be compared: the margin is set with the cohort.
  [[nodiscard]] bool hasAnalysisPlan() const noexcept { return equivalenceMargin.has_value(); }

  std::vector<CohortGroup> groups;
  std::vector<CohortTrainee> trainees;
  CohortAllocation allocation;

  EvaluationInstrument instrument;
  EvaluationPolicy evaluationPolicy;
  std::vector<ModelRatings> ratings;         ///< in the order of the models in the report
  std::vector<ModelEvaluation> evaluations;  ///< same order; none while the evaluation is unfinished
  std::size_t chiefClass = 2;                ///< the class of Fig. 18
  std::optional<UnfinishedEvaluation> unfinishedEvaluation;  ///< in place of the two

  ScoreScale trainingScale{10, 100, 10};
  std::vector<Text> occasions;  ///< "before", "after 20 min", "after 40 min"
  std::vector<TraineeScore> scores;
  std::vector<GroupSummary> summaries;
  std::size_t trainingRaters = 0;
  /// The marks behind the scores. When given, the report has a section with agreement and comparisons.
  std::vector<TrainingMark> trainingMarks;
  /// The sheets behind these marks, and what was given for their criteria; empty: entered without a sheet.
  std::vector<ReportedSheet> sheets;
  std::vector<CriterionMark> criterionMarks;
  /// Whether the reader may see single marks; scores, agreement and severity are shown in any case.
  bool singleMarks = true;

  MarkWays markWays;
  std::int64_t sheetsAsked = 0;            ///< of raters for this cohort, without those withdrawn
  std::int64_t sheetsPresent = 0;          ///< of them, submitted
  std::int64_t evaluationRatersAsked = 0;  ///< raters of the campaign; 0: not known
  std::int64_t modelsHidden = 0;  ///< evaluated models that stood before their raters under a hidden label

  std::int64_t notAssessable = 0;  ///< marks that a rater could not give, with a reason
  std::vector<CohortDose> doses;
  std::vector<CohortDeviation> deviations;
  std::vector<CohortSignature> signatures;  ///< of the marks that were signed
  std::int64_t unsignedMarks = 0;           ///< the others

  std::vector<TrialSummaryRow> trials;
  std::vector<CohortCompetence> competence;
  Facts provenance;  ///< organ hash, parameter hash, database schema ...
};

/// Makes the cohort report as plain values (paper sections 5.3 and 6: Figs. 15 to 23). Same inputs, same
/// report. Throws Error{kBadData} when lists that belong together differ in length.
[[nodiscard]] ReportModel cohortReport(const CohortInputs& inputs);

}  // namespace torsio
