// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/scoring_service.h"

#include <algorithm>
#include <map>
#include <utility>

#include "app/session/build_info.h"
#include "db/repository/study_repository.h"
#include "sim/base/contracts.h"
#include "sim/base/digest.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

template <typename Items, typename Key>
std::size_t positionOf(const Items& items, const std::string& wanted, Key key) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return key(item) == wanted; });
  TORSIO_EXPECTS(found != items.end());  // the database holds the reference
  return static_cast<std::size_t>(found - items.begin());
}

AssessmentRun makeRun(IdSource& ids, const ScoringStamp& stamp, const char* formula,
                      const std::string& policy, const Digest& inputs) {
  AssessmentRun run;
  run.id = ids.newUuid();
  run.formulaVersion = formula;
  run.policy = policy;
  run.inputsHash = inputs.hex();
  run.softwareVersion = softwareVersion();
  run.computedUtc_us = stamp.utc_us;
  run.demonstration = stamp.demonstration;
  if (stamp.demonstration) run.flags.push_back("demonstration data");
  return run;
}

StoredEvaluationResult stored(const std::string& model, std::size_t index, const ScoreStatistics& from) {
  StoredEvaluationResult to;
  to.modelCode = model;
  to.indexNumber = static_cast<std::int64_t>(index + 1);
  to.weightedMean = from.m;
  to.variance = from.s2;
  to.raterCount = from.n;
  to.missingCount = from.missing;
  to.lowest = from.min;
  to.highest = from.max;
  to.plainMean = from.plainMean;
  to.populationVariance = from.populationVariance;
  to.sampleVariance = from.sampleVariance;
  to.standardError = from.standardError;
  to.flags = from.flags;
  return to;
}

/// Variance of one trainee's marks between the raters, divisor n.
double betweenRaterVariance(const std::vector<TrainingMark>& marks, const TraineeScore& score,
                            const ScoreScale& scale) {
  double sum = 0.0;
  std::int64_t n = 0;
  for (const TrainingMark& mark : marks) {
    if (mark.trainee != score.trainee || mark.occasion != score.occasion) continue;
    const double distance = pointsFromSteps(mark.steps, scale) - score.score;
    sum += distance * distance;
    ++n;
  }
  return n > 0 ? sum / static_cast<double>(n) : 0.0;
}

}  // namespace

const std::vector<std::string>& scoringPoints() {
  static const std::vector<std::string> kPoints{"pre", "mid", "post"};
  return kPoints;
}

CampaignResult evaluateCampaign(Connection& connection, const std::string& campaignId, IdSource& ids,
                                const ScoringStamp& stamp) {
  EvaluationRepository repository(connection);
  const auto campaign = repository.campaign(campaignId);
  if (!campaign) {
    throw Error(ErrorCode::kBadData, "no evaluation campaign has this id", campaignId,
                "List the campaigns first");
  }
  CampaignResult result{*campaign, {}, {}};
  Digest inputs;
  for (const StoredEvaluationMark& mark : repository.marks(campaignId)) {
    EvaluationRating rating;
    rating.model = mark.modelCode;
    rating.rater = mark.raterCode;
    rating.raterClass =
        positionOf(campaign->instrument.classes, mark.classCode, [](const RaterClass& c) { return c.id; });
    rating.index = static_cast<std::size_t>(mark.indexNumber - 1);
    rating.steps = mark.score_steps;
    inputs.update(mark.id);
    inputs.update(mark.version);
    inputs.update(mark.score_steps);
    result.ratings.push_back(std::move(rating));
  }
  result.models = evaluate(campaign->instrument, result.ratings);
  std::stable_sort(result.models.begin(), result.models.end(), [&](const auto& a, const auto& b) {
    const auto code = [](const StoredModel& m) { return m.code; };
    return positionOf(campaign->models, a.model, code) < positionOf(campaign->models, b.model, code);
  });

  StoredEvaluationRun run;
  run.run = makeRun(ids, stamp, kEvaluationFormulaVersion, "available-case", inputs);
  for (const ModelEvaluation& model : result.models) {
    for (std::size_t i = 0; i < model.indices.size(); ++i)
      run.results.push_back(stored(model.model, i, model.indices[i]));
    StoredComposite composite{model.model, model.n27, {}, model.flags};
    if (model.compositeStatistics) composite.standardError = model.compositeStatistics->standardError;
    run.composites.push_back(std::move(composite));
  }
  repository.storeRun(campaignId, run);
  return result;
}

TrainingResult scoreTraining(Connection& connection, const std::string& cohortId, IdSource& ids,
                             const ScoringStamp& stamp) {
  StudyRepository study(connection);
  RatingRepository ratings(connection);
  const std::vector<StoredGroup> groups = study.groups(cohortId);
  std::map<std::string, std::string> enrolmentOf;  // trainee code -> enrolment id
  for (const StoredEnrolment& enrolment : study.enrolments(cohortId))
    enrolmentOf[enrolment.traineeCode] = enrolment.id;

  TrainingResult result;
  std::map<std::pair<std::string, std::string>, std::int64_t> notAssessable;  // by trainee and scoring point
  Digest inputs;
  for (const StoredTrainingMark& mark : ratings.marks(cohortId)) {
    inputs.update(mark.id);
    inputs.update(mark.version);
    inputs.update(mark.score_steps.value_or(-1));
    if (!mark.score_steps) {
      ++notAssessable[{mark.traineeCode, mark.scoringPoint}];
      continue;
    }
    result.scale = mark.scale;
    TrainingMark scored;
    scored.trainee = mark.traineeCode;
    scored.group = positionOf(groups, mark.groupCode, [](const StoredGroup& g) { return g.code; });
    scored.occasion = positionOf(scoringPoints(), mark.scoringPoint, [](const std::string& p) { return p; });
    scored.rater = mark.raterCode;
    scored.steps = *mark.score_steps;
    result.marks.push_back(std::move(scored));
  }
  result.trainees = traineeScores(result.scale, result.marks);
  result.groups = groupSummaries(result.scale, result.marks);

  StoredTrainingRun run;
  run.run = makeRun(ids, stamp, kTrainingFormulaVersion, "mean of the raters who marked", inputs);
  for (const TraineeScore& score : result.trainees) {
    run.trainees.push_back({enrolmentOf.at(score.trainee),
                            scoringPoints().at(score.occasion),
                            score.score,
                            betweenRaterVariance(result.marks, score, result.scale),
                            score.n,
                            notAssessable[{score.trainee, scoringPoints().at(score.occasion)}],
                            {}});
  }
  for (const GroupSummary& group : result.groups) {
    run.groups.push_back({groups.at(group.group).id,
                          scoringPoints().at(group.occasion),
                          group.trainees,
                          group.mean,
                          group.varianceOfScores,
                          group.sampleVarianceOfScores,
                          {}});
  }
  ratings.storeRun(cohortId, run);
  return result;
}

}  // namespace torsio
