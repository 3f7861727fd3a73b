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

/// What a computation stores with its results.
struct ScoringStamp {
  std::int64_t utc_us = 0;
  bool demonstration = false;
};

/// The nine-index evaluation of a stored campaign.
struct CampaignResult {
  Campaign campaign;
  std::vector<EvaluationRating> ratings;    ///< latest version of each mark, models by code
  std::vector<ModelEvaluation> models;      ///< in the campaign's order; empty: incomplete
  std::vector<std::string> classesMissing;  ///< names of weighted classes that have not scored everything
  std::vector<UnscoredIndices> unscored;    ///< what they have not scored
};

/// Evaluates the marks of a campaign without storing anything, for previews and reports. Until every weighted
/// class of raters has scored every index of every model, there are marks but no models. Throws
/// Error{kBadData} if there is no such campaign.
[[nodiscard]] CampaignResult readCampaign(Connection& connection, const CampaignId& campaignId);

/// Computes Eqs. 25-27 from the marks of a campaign, stores the results with formula version, policy and hash
/// of the marks, and returns them. Throws Error{kBadData} if there is no such campaign or a class is empty.
[[nodiscard]] CampaignResult evaluateCampaign(Connection& connection, const CampaignId& campaignId,
                                              IdSource& ids, const ScoringStamp& stamp);

/// The training study of a stored cohort.
struct TrainingResult {
  Occasions occasions;  ///< of the cohort, in order of time; marks and scores refer to their indices
  ScoreScale scale;
  std::vector<TrainingMark> marks;  ///< assessable marks
  std::vector<TraineeScore> trainees;
  std::vector<GroupSummary> groups;
  std::int64_t notAssessable = 0;        ///< number of "not assessable" answers
  MarkWays ways;                         ///< how `marks` were made
  std::vector<SubmittedMark> submitted;  ///< all marks from RatingRepository::marks()
};

/// Reads the marks of a cohort with scores and summaries, without storing anything.
[[nodiscard]] TrainingResult readTraining(Connection& connection, const CohortId& cohortId);

/// Computes trainee scores and group summaries from the marks of a cohort, stores and returns them.
[[nodiscard]] TrainingResult scoreTraining(Connection& connection, const CohortId& cohortId, IdSource& ids,
                                           const ScoringStamp& stamp);

/// Returns the occasions of a cohort in order of time: those of its curriculum, with their training times,
/// and others with marks or assignments. Without occasions in the curriculum: all occasions of the record;
/// for imported recordings: those with marks. Throws Error{kBadData} if there is no such cohort.
[[nodiscard]] Occasions occasionsOfCohort(Connection& connection, const CohortId& cohortId);

}  // namespace torsio
