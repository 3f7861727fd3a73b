// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/report/report_model.h"
#include "assessment/scoring/evaluation.h"
#include "assessment/scoring/training_scores.h"

namespace torsio {

/// A trainee as the report shows one: a code, never a name.
struct CohortTrainee {
  std::string code;
  std::size_t group = 0;
  std::string sex;
  std::string level;
};

/// A group and what it does.
struct CohortGroup {
  std::string name;      ///< "Group 1"
  std::string protocol;  ///< "40 min virtual"
};

/// How trainees came into their groups.
struct CohortAllocation {
  std::string method;
  std::string version;
  std::string generator;
  std::uint64_t seed = 0;
  std::string commitment;
  bool replayed = false;  ///< the sequence was repeated from the seed and found the same
};

/// What one recorded trial comes down to.
struct TrialDigest {
  std::string trialId;
  std::string trainee;
  std::size_t group = 0;
  std::string phase;  ///< "virtual 0-20 min"
  std::string model;
  double minutes = 0.0;
  std::int64_t samples = 0;
  std::int64_t twists = 0;
  std::int64_t twistsOnTarget = 0;              ///< ended within the tolerance
  std::optional<double> meanAbsoluteError_deg;  ///< of the held angle against the target
  std::optional<double> peakTorque_Nm;
  std::optional<double> peakForce_N;
  std::int64_t refusedSamples = 0;
  std::int64_t lateTicks = 0;
  bool interrupted = false;
  std::string contentHash;
};

/// Everything a cohort report is made from.
struct CohortInputs {
  std::string title = "Cohort report";
  std::string centre;
  std::string softwareVersion;
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
  std::vector<std::string> simulated;  ///< one sentence each: what of this is simulated and by which rule
  std::vector<std::pair<std::string, std::string>> facts;  ///< further lines for the cover: label, value
  std::int64_t trainingTimeDivisor = 1;  ///< 60: one simulated minute stands for one hour of training
  std::int64_t rests = 0;                ///< trainees who took a rest

  std::vector<CohortGroup> groups;
  std::vector<CohortTrainee> trainees;
  CohortAllocation allocation;

  EvaluationInstrument instrument;
  EvaluationPolicy evaluationPolicy;
  std::vector<ModelRatings> ratings;         ///< in the order of the models in the report
  std::vector<ModelEvaluation> evaluations;  ///< same order
  std::size_t chiefClass = 2;                ///< the class of Fig. 18

  ScoreScale trainingScale{10, 100, 10};
  std::vector<std::string> occasions;  ///< "before", "after 20 min", "after 40 min"
  std::vector<TraineeScore> scores;
  std::vector<GroupSummary> summaries;
  std::size_t trainingRaters = 0;
  /// The marks behind the scores. When given, the report has a section with agreement and comparisons.
  std::vector<TrainingMark> trainingMarks;

  std::vector<TrialDigest> trials;
  std::vector<std::pair<std::string, std::string>>
      provenance;  ///< organ hash, parameter hash, database schema ...
};

/// The cohort report as plain values (paper sections 5.3 and 6: Figs. 15 to 23). Same inputs, same report.
/// Throws Error{kBadData} when lists that belong together differ in length.
[[nodiscard]] ReportModel cohortReport(const CohortInputs& inputs);

}  // namespace torsio
