// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/scoring/scoring_service.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "app/services/base/build_info.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/assessment_run.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

template <typename Items, typename Key>
std::size_t positionOf(const Items& items, const std::string& wanted, Key key) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return key(item) == wanted; });
  TORSIO_EXPECTS(found != items.end());  // guaranteed by a foreign key
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
  if (stamp.demonstration) {
    run.flags.push_back("demonstration data");
  }
  return run;
}

EvaluationResultRow stored(const std::string& model, std::size_t index, const ScoreStatistics& from) {
  EvaluationResultRow to;
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

/// Results with the hash of their input marks.
struct ReadCampaign {
  CampaignResult result;
  Digest inputs;
};

/// Returns the indices that nobody of a weighted class has scored, by model.
std::vector<UnscoredIndices> unscoredIndices(const Campaign& campaign,
                                             const std::vector<EvaluationRating>& ratings) {
  using Place = std::tuple<std::string, std::size_t, std::size_t>;  // model, class, index
  std::set<Place> scored;
  for (const EvaluationRating& rating : ratings) {
    scored.insert({rating.model, rating.raterClass, rating.index});
  }
  std::vector<UnscoredIndices> unscored;
  const EvaluationInstrument& instrument = campaign.instrument;
  for (std::size_t c = 0; c < instrument.classes.size(); ++c) {
    if (instrument.classes[c].weight_milli == 0) {
      continue;
    }
    for (const CampaignModel& model : campaign.models) {
      UnscoredIndices of{instrument.classes[c].name, model.code, {}};
      for (std::size_t j = 0; j < instrument.indices.size(); ++j) {
        if (!scored.contains({model.code, c, j})) {
          of.indices.push_back(instrument.indices[j].name);
        }
      }
      if (!of.indices.empty()) {
        unscored.push_back(std::move(of));
      }
    }
  }
  return unscored;
}

ReadCampaign campaignWithHash(Connection& connection, const CampaignId& campaignId) {
  EvaluationRepository repository(connection);
  const auto campaign = repository.campaign(campaignId);
  if (!campaign) {
    refuse(Text::tr("no evaluation campaign has this id"), campaignId, Text::tr("List the campaigns first"));
  }
  ReadCampaign read{{*campaign, {}, {}, {}, {}}, {}};
  for (const EvaluationMark& mark : repository.marks(campaignId)) {
    EvaluationRating rating;
    rating.model = mark.modelCode;
    rating.rater = mark.raterCode;
    rating.raterClass =
        positionOf(campaign->instrument.classes, mark.classCode, [](const RaterClass& c) { return c.id; });
    rating.index = static_cast<std::size_t>(mark.indexNumber - 1);
    rating.steps = mark.score_steps;
    rating.id = mark.id;
    read.inputs.update(mark.id.text());
    read.inputs.update(mark.version);
    read.inputs.update(mark.score_steps);
    read.result.ratings.push_back(std::move(rating));
  }
  read.result.unscored = unscoredIndices(*campaign, read.result.ratings);
  for (const UnscoredIndices& of : read.result.unscored) {  // class by class
    if (read.result.classesMissing.empty() || read.result.classesMissing.back() != of.raterClass) {
      read.result.classesMissing.push_back(of.raterClass);
    }
  }
  return read;
}

void evaluateIn(CampaignResult& result) {
  const Campaign& campaign = result.campaign;
  result.models = evaluate(campaign.instrument, result.ratings);
  std::stable_sort(result.models.begin(), result.models.end(), [&](const auto& a, const auto& b) {
    const auto code = [](const CampaignModel& m) { return m.code; };
    return positionOf(campaign.models, a.model, code) < positionOf(campaign.models, b.model, code);
  });
}

using Case = std::pair<std::string, std::size_t>;  // trainee code, index of the occasion

struct ReadTraining {
  TrainingResult result;
  std::map<Case, std::int64_t> notAssessable;
  Digest inputs;
};

ReadTraining trainingWithHash(Connection& connection, const CohortId& cohortId) {
  const std::vector<StudyGroup> groups = StudyRepository(connection).groups(cohortId);
  ReadTraining read;
  read.result.occasions = occasionsOfCohort(connection, cohortId);
  read.result.submitted = RatingRepository(connection).marks(cohortId);
  std::map<std::string, std::string> classOf;  // of raters, by code
  for (const Rater& rater : PeopleRepository(connection).raters()) {
    classOf[rater.person.code] = rater.classCode;
  }
  for (const SubmittedMark& mark : read.result.submitted) {
    read.inputs.update(mark.id.text());
    read.inputs.update(mark.version);
    read.inputs.update(mark.score_steps.value_or(-1));
    const std::size_t occasion =
        positionOf(read.result.occasions, mark.occasionCode, [](const Occasion& one) { return one.code; });
    if (!mark.score_steps) {
      ++read.notAssessable[{mark.traineeCode, occasion}];
      ++read.result.notAssessable;
      continue;
    }
    if (mark.groupCode.empty()) {
      continue;  // marked before allocation, and still without a group
    }
    read.result.scale = mark.scale;
    TrainingMark scored;
    scored.trainee = mark.traineeCode;
    scored.group = positionOf(groups, mark.groupCode, [](const StudyGroup& g) { return g.code; });
    scored.occasion = occasion;
    scored.rater = mark.raterCode;
    scored.steps = *mark.score_steps;
    scored.id = mark.id;
    scored.version = mark.version;
    scored.submittedUtc_us = mark.submittedUtc_us;
    scored.raterClass = classOf[mark.raterCode];
    scored.way = mark.assignmentId.empty() ? MarkWay::kEntered
                 : mark.trialId.empty()    ? MarkWay::kLive
                                           : MarkWay::kBlinded;
    ++(scored.way == MarkWay::kEntered ? read.result.ways.entered
       : scored.way == MarkWay::kLive  ? read.result.ways.live
                                       : read.result.ways.blinded);
    read.result.marks.push_back(std::move(scored));
  }
  read.result.trainees = traineeScores(read.result.scale, read.result.marks);
  read.result.groups = groupSummaries(read.result.scale, read.result.marks);
  return read;
}

/// Returns the between-rater variance of every trainee's marks, divisor n, by trainee and occasion.
std::map<Case, double> betweenRaterVariances(const TrainingResult& result) {
  std::map<Case, double> means;
  for (const TraineeScore& score : result.trainees) {
    means[{score.trainee, score.occasion}] = score.score;
  }
  std::map<Case, std::pair<double, double>> sums;
  for (const TrainingMark& mark : result.marks) {
    const Case key{mark.trainee, mark.occasion};
    const double distance = pointsFromSteps(mark.steps, result.scale) - means.at(key);
    sums[key].first += distance * distance;
    sums[key].second += 1.0;
  }
  std::map<Case, double> variances;
  for (const auto& [key, sum] : sums) {
    variances[key] = sum.first / sum.second;
  }
  return variances;
}

}  // namespace

CampaignResult readCampaign(Connection& connection, const CampaignId& campaignId) {
  CampaignResult result = campaignWithHash(connection, campaignId).result;
  if (result.classesMissing.empty()) {
    evaluateIn(result);
  }
  return result;
}

TrainingResult readTraining(Connection& connection, const CohortId& cohortId) {
  return trainingWithHash(connection, cohortId).result;
}

CampaignResult evaluateCampaign(Connection& connection, const CampaignId& campaignId, IdSource& ids,
                                const ScoringStamp& stamp) {
  auto [result, inputs] = campaignWithHash(connection, campaignId);
  if (!result.ratings.empty()) {
    evaluateIn(result);
  }
  EvaluationRunRows run;
  run.run = makeRun(ids, stamp, kEvaluationFormulaVersion, "available-case", inputs);
  for (const ModelEvaluation& model : result.models) {
    for (std::size_t i = 0; i < model.indices.size(); ++i) {
      run.results.push_back(stored(model.model, i, model.indices[i]));
    }
    CompositeRow composite{model.model, model.n27, {}, model.flags};
    if (model.compositeStatistics) {
      composite.standardError = model.compositeStatistics->standardError;
    }
    run.composites.push_back(std::move(composite));
  }
  EvaluationRepository(connection).storeRun(campaignId, run);
  return result;
}

TrainingResult scoreTraining(Connection& connection, const CohortId& cohortId, IdSource& ids,
                             const ScoringStamp& stamp) {
  StudyRepository study(connection);
  const std::vector<StudyGroup> groups = study.groups(cohortId);
  std::map<std::string, std::string> enrolmentOf;  // trainee code -> enrolment id
  for (const Enrolment& enrolment : study.enrolments(cohortId)) {
    enrolmentOf[enrolment.traineeCode] = enrolment.id;
  }
  auto [result, notAssessable, inputs] = trainingWithHash(connection, cohortId);
  const std::map<Case, double> variances = betweenRaterVariances(result);

  TrainingRunRows run;
  run.run = makeRun(ids, stamp, kTrainingFormulaVersion, "mean of the raters who marked", inputs);
  for (const TraineeScore& score : result.trainees) {
    run.trainees.push_back({enrolmentOf.at(score.trainee),
                            result.occasions.at(score.occasion).code,
                            score.score,
                            variances.at({score.trainee, score.occasion}),
                            score.n,
                            notAssessable[{score.trainee, score.occasion}],
                            {}});
  }
  for (const GroupSummary& group : result.groups) {
    run.groups.push_back({groups.at(group.group).id,
                          result.occasions.at(group.occasion).code,
                          group.trainees,
                          group.mean,
                          group.varianceOfScores,
                          group.sampleVarianceOfScores,
                          {}});
  }
  RatingRepository(connection).storeRun(cohortId, run);
  return result;
}

Occasions occasionsOfCohort(Connection& connection, const CohortId& cohortId) {
  const Cohort cohort = StudyRepository(connection).cohort(cohortId);
  OccasionRepository repository(connection);
  Occasions all = repository.all();
  const auto version = CurriculumRepository(connection).version(cohort.curriculumVersionId);
  const std::set<std::string> used = repository.usedBy(cohortId);
  std::vector<Occasion> own;
  if (!used.empty() && repository.cameFromElsewhere(cohortId)) {
    std::copy_if(all.begin(), all.end(), std::back_inserter(own),
                 [&](const Occasion& occasion) { return used.contains(occasion.code); });
    return Occasions(std::move(own));
  }
  if (!version || version->plannedOccasions.empty()) {
    return all;
  }
  for (Occasion occasion : all) {
    for (const PlannedOccasion& point : version->plannedOccasions) {
      if (point.code == occasion.code) {
        occasion.afterExposure_us = point.afterExposure_us;
      }
    }
    if (occasion.afterExposure_us || used.contains(occasion.code)) {
      own.push_back(std::move(occasion));
    }
  }
  return Occasions(std::move(own));
}

}  // namespace torsio
