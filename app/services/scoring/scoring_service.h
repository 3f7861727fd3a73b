// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/occasion.h"
#include "assessment/results/cohort_report.h"
#include "assessment/scoring/evaluation.h"
#include "assessment/scoring/training_scores.h"

namespace torsio {

class Connection;
class IdSource;

/// Stamps what a computation leaves in the record.
struct ScoringStamp {
  std::int64_t utc_us = 0;
  bool demonstration = false;
};

/// The nine-index evaluation of a stored campaign.
struct CampaignResult {
  Campaign campaign;
  std::vector<EvaluationRating> ratings;    ///< the newest version of each mark, models by their code
  std::vector<ModelEvaluation> models;      ///< in the campaign's order; empty: not finished
  std::vector<std::string> classesMissing;  ///< names of the weighted classes that have not scored everything
  std::vector<UnscoredIndices> unscored;    ///< what these have not scored
};

/// Reads and evaluates the marks of a campaign without storing anything, for previews and reports. While a
/// class of raters that has a weight has not scored every index of every model, there are marks but no
/// models. Throws Error{kBadData} when there is no such campaign.
[[nodiscard]] CampaignResult readCampaign(Connection& connection, const CampaignId& campaignId);

/// Reads the marks of a campaign, computes Eqs. 25-27, stores the results with formula version, policy and
/// the hash of the marks, and returns them. Throws Error{kBadData} when there is no such campaign or a class
/// is empty.
[[nodiscard]] CampaignResult evaluateCampaign(Connection& connection, const CampaignId& campaignId,
                                              IdSource& ids, const ScoringStamp& stamp);

/// The training study of a stored cohort.
struct TrainingResult {
  Occasions occasions;  ///< of the cohort, in order of time; marks and scores name their positions
  ScoreScale scale;
  std::vector<TrainingMark> marks;  ///< assessable ones
  std::vector<TraineeScore> trainees;
  std::vector<GroupSummary> groups;
  std::int64_t notAssessable = 0;        ///< marks that could not be given
  MarkWays ways;                         ///< how `marks` were given
  std::vector<SubmittedMark> submitted;  ///< all marks as RatingRepository::marks() reads them
};

/// The marks of a cohort with scores and summaries, without storing anything.
[[nodiscard]] TrainingResult readTraining(Connection& connection, const CohortId& cohortId);

/// Reads the marks of a cohort, computes trainee scores and group summaries, stores and returns them.
[[nodiscard]] TrainingResult scoreTraining(Connection& connection, const CohortId& cohortId, IdSource& ids,
                                           const ScoringStamp& stamp);

/// Gives the occasions of a cohort in order of time: those of its curriculum, with their times of exposure,
/// and any other at which it was marked or raters are asked. A cohort whose curriculum names none has all
/// occasions of the record; one of recordings of other equipment those at which it was marked. Throws
/// Error{kBadData} when there is no such cohort.
[[nodiscard]] Occasions occasionsOfCohort(Connection& connection, const CohortId& cohortId);

}  // namespace torsio
