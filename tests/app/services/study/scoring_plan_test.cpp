// SPDX-License-Identifier: GPL-3.0-or-later
// Scoring plans and evaluations of models, through the services.
#include "app/services/study/scoring_plan.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/people/people_service.h"
#include "app/services/study/campaign_service.h"
#include "app/services/study/open_sheets.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/app/support/six_trainees.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

TEST(ScoringPlan, EveryRaterScoresEveryTraineeAtEveryOccasionOnce) {
  SixTrainees study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");

  const ScoringPlanOutcome first = createAssignments(session, study.plan());
  const ScoringPlanOutcome again = createAssignments(session, study.plan());

  EXPECT_EQ(first.created, 3U * 6U * 3U);
  EXPECT_EQ(again.created, 0U);
  EXPECT_EQ(again.already, 3U * 6U * 3U);
  const ScoringMatrix matrix = scoringMatrix(session, study.cohortId);
  ASSERT_EQ(matrix.raters.size(), 3U);
  ASSERT_EQ(matrix.lines.size(), 18U);
  for (const ScoringMatrix::Line& line : matrix.lines) {
    EXPECT_EQ(line.missing, 3U);
  }
}

TEST(ScoringPlan, LiveCasesHaveOneLabelForAllAndOrdersDiffer) {
  SixTrainees study;
  study.allocate();
  createAssignments(study.centre.as("administrator"), study.plan());

  SheetRepository sheets(study.centre.connection());
  std::map<std::string, std::set<std::string>> labelsOfCase;
  std::vector<std::vector<std::string>> orders;
  for (const std::string& chief : study.chiefs) {
    orders.emplace_back();
    for (const Assignment& one : sheets.assignmentsOf(chief)) {
      labelsOfCase[one.enrolmentId + one.occasionCode].insert(one.caseLabel);
      orders.back().push_back(one.enrolmentId + one.occasionCode);
    }
  }
  for (const auto& [key, labels] : labelsOfCase) {
    EXPECT_EQ(labels.size(), 1U);
  }
  EXPECT_NE(orders[0], orders[1]);
  EXPECT_NE(orders[1], orders[2]);
}

TEST(ScoringPlan, LabelsDoNotFollowStageOrGroup) {
  SixTrainees study;
  study.allocate();
  createAssignments(study.centre.as("administrator"), study.plan());

  // Sorted by label, cases of a stage would be adjacent if labels followed the stage.
  std::vector<std::pair<std::string, std::string>> byLabel;
  for (const Assignment& one : SheetRepository(study.centre.connection()).assignmentsOf(study.chiefs[0])) {
    byLabel.emplace_back(one.caseLabel, one.occasionCode);
  }
  std::sort(byLabel.begin(), byLabel.end());
  std::size_t changes = 0;
  for (std::size_t i = 1; i < byLabel.size(); ++i) {
    changes += byLabel[i].second != byLabel[i - 1].second ? 1 : 0;
  }

  EXPECT_GT(changes, 6U);  // two if sorted by stage; about twelve of seventeen at random
}

TEST(ScoringPlan, ReassigningNeedsAReasonAndARaterNotYetAssigned) {
  SixTrainees study;
  SessionContext& session = study.centre.as("administrator");
  ScoringPlan plan = study.plan();
  plan.occasionCodes = {"pre"};
  plan.raterIds.pop_back();
  createAssignments(session, plan);
  const ScoringCell cell = scoringMatrix(session, study.cohortId).lines.at(0).cells.at(0);

  const std::array sheets{cell.assignmentId};
  EXPECT_THROW(reassignAll(session, sheets, study.chiefs[2], ""), Error);
  EXPECT_THROW(reassignAll(session, sheets, study.chiefs[1], "ill"), Error);

  EXPECT_EQ(reassignAll(session, sheets, study.chiefs[2], "ill").moved, 1U);

  const ScoringMatrix matrix = scoringMatrix(session, study.cohortId);
  EXPECT_EQ(matrix.raters.size(), 3U);
  EXPECT_EQ(matrix.lines.at(0).cells.at(0).state, SheetState::kWithdrawn);
  EXPECT_EQ(matrix.lines.at(0).cells.at(2).caseLabel, cell.caseLabel);
  EXPECT_EQ(study.centre.audited("assignment.reassign"), 1);
}

TEST(ScoringPlan, MarksAreReleasedWhenAllAreInOrWithAReason) {
  SixTrainees study;
  SessionContext& session = study.centre.as("administrator");
  createAssignments(session, study.plan());
  study.submitAll("pre");

  releaseMarks(session, study.cohortId, "pre");
  EXPECT_THROW(releaseMarks(session, study.cohortId, "mid"), Error);
  releaseMarks(session, study.cohortId, "mid", "two raters are ill");
  EXPECT_THROW(retractMarks(session, study.cohortId, "mid", ""), Error);
  retractMarks(session, study.cohortId, "mid", "they are back");

  const std::vector<ReleaseState> states = releaseStates(session, study.cohortId);
  ASSERT_EQ(states.size(), 3U);
  EXPECT_TRUE(states[0].released);
  EXPECT_EQ(states[0].missing, 0U);
  EXPECT_FALSE(states[1].released);
  EXPECT_EQ(states[1].missing, 18U);
  EXPECT_EQ(study.centre.audited("mark.release"), 2);
  EXPECT_EQ(study.centre.audited("mark.retract"), 1);
}

/// Stores a free practice recording like the station.
void storeRecording(Connection& connection, const char* id, TissueModel model) {
  TrialRepository trials(connection, {.station = "station-1"});
  Trial trial;
  trial.header.trialId = id;
  trial.header.model = model;
  trials.begin(trial.header);
  std::vector<Sample> samples(3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].tick = static_cast<std::int64_t>(i);
  }
  trial.chunks.push_back(encodeChunk(0, samples));
  trials.append(trial.chunks.front());
  trial.summary.samples = 3;
  trial.summary.contentHash = contentHash(trial);
  trials.finish(trial.summary);
}

TEST(CampaignService, AcceptsOneFinishedRecordingOfEachModel) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  storeRecording(centre.connection(), "with-twist", TissueModel::kTwist);
  storeRecording(centre.connection(), "with-elements", TissueModel::kFiniteElements);
  storeRecording(centre.connection(), "with-springs", TissueModel::kMassSpring);
  CampaignPlan plan;
  plan.name = "Recorded models";
  plan.instrument = paperEvaluationInstrument();
  for (const char* raterClass : {"intern", "deputy_chief", "chief"}) {
    plan.raterIds.push_back(addPerson(
        session,
        {.fullName = "Rater", .externalId = raterClass, .trainee = false, .raterClass = raterClass}));
  }
  const auto refused = [&](std::vector<NewModel> models) {
    plan.models = std::move(models);
    try {
      addCampaign(session, plan);
    } catch (const Error& error) {
      return error.code() == ErrorCode::kBadParameter;
    }
    return false;
  };

  EXPECT_EQ(evaluationRecordings(session).size(), 3U);
  EXPECT_TRUE(refused({{"PM", "proposed", "with-twist"}, {"FEM", "finite elements"}}));
  EXPECT_TRUE(refused({{"PM", "proposed", "with-twist"}, {"FEM", "finite elements", "with-twist"}}));
  plan.models = {{"PM", "proposed", "with-twist"},
                 {"FEM", "finite elements", "with-elements"},
                 {"MSM", "mass-spring", "with-springs"}};
  addCampaign(session, plan);

  const CampaignRow row = campaigns(session).at(0);
  EXPECT_EQ(row.campaign.models[1].trialId, "with-elements");
  EXPECT_EQ(TrialRepository(centre.connection()).load("with-springs").header.model, TissueModel::kMassSpring);
}

TEST(CampaignService, OrdersAreCounterbalancedWithinEachClass) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  CampaignPlan plan;
  plan.name = "Models";
  plan.instrument = paperEvaluationInstrument();
  plan.models = {{"PM", "proposed"}, {"FEM", "finite elements"}, {"MSM", "mass-spring"}};
  for (const char* raterClass : {"intern", "deputy_chief", "chief"}) {
    for (int i = 0; i < 6; ++i) {
      plan.raterIds.push_back(addPerson(session, {.fullName = "Rater",
                                                  .externalId = std::string(raterClass) + std::to_string(i),
                                                  .trainee = false,
                                                  .raterClass = raterClass}));
    }
  }

  addCampaign(session, plan);

  const CampaignRow row = campaigns(session).at(0);
  std::map<std::string, std::set<std::string>> orders;
  for (const CampaignRater& rater : row.campaign.raters) {
    orders[rater.classCode].insert(rater.modelOrder);
  }
  for (const auto& [code, seen] : orders) {
    EXPECT_EQ(seen.size(), 6U) << code;  // 3! orders, six raters
  }
  EXPECT_EQ(row.marksExpected, 18U * 3U * 9U);
  std::set<std::string> hidden;
  for (const CampaignModel& model : row.campaign.models) {
    hidden.insert(model.hiddenLabel);
  }
  EXPECT_EQ(hidden, (std::set<std::string>{"X", "Y", "Z"}));
}

TEST(CampaignService, RejectsAWeightedClassWithoutRaters) {
  StudyCentre centre;
  CampaignPlan plan;
  plan.name = "Models";
  plan.instrument = paperEvaluationInstrument();
  plan.models = {{"PM", "proposed"}, {"FEM", "finite elements"}};
  plan.raterIds = centre.addChiefs(2);

  EXPECT_THROW(addCampaign(centre.session(), plan), Error);
  plan.instrument.classes[2].weight_milli = 600;
  EXPECT_THROW(addCampaign(centre.session(), plan), Error);
  EXPECT_TRUE(campaigns(centre.session()).empty());
}

/// Three groups of ten at three stages.
std::vector<OrderedCase> paperCases() {
  std::vector<OrderedCase> cases;
  for (const char* stage : {"pre", "mid", "post"}) {
    for (const char* group : {"G1", "G2", "G3"}) {
      for (int i = 0; i < 10; ++i) {
        cases.push_back({cases.size(), std::string(stage) + " " + group});
      }
    }
  }
  return cases;
}

TEST(CaseOrder, IsADifferentPermutationForEachRater) {
  const std::vector<OrderedCase> cases = paperCases();

  std::vector<std::size_t> first = counterbalancedOrder(cases, 5, 0);
  const std::vector<std::size_t> second = counterbalancedOrder(cases, 5, 1);

  EXPECT_EQ(first, counterbalancedOrder(cases, 5, 0));
  EXPECT_NE(first, second);
  EXPECT_NE(first, counterbalancedOrder(cases, 6, 0));
  std::sort(first.begin(), first.end());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i], i);
  }
}

TEST(CaseOrder, SpreadsStagesAndGroupsEvenlyOverTheSession) {
  const std::vector<OrderedCase> cases = paperCases();

  const std::vector<std::size_t> order = counterbalancedOrder(cases, 5, 3);

  // Nine strata of ten: each successive nine cases contain each stratum once.
  for (std::size_t round = 0; round < 10; ++round) {
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < 9; ++i) {
      ++seen[cases[order[round * 9 + i]].stratum];
    }
    EXPECT_EQ(seen.size(), 9U) << round;
  }
}

TEST(CaseOrder, SpreadsSmallStrataToo) {
  std::vector<OrderedCase> cases;
  for (std::size_t i = 0; i < 20; ++i) {
    cases.push_back({i, i < 4 ? "few" : "many"});
  }

  const std::vector<std::size_t> order = counterbalancedOrder(cases, 1, 0);

  std::size_t inFirstHalf = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    inFirstHalf += cases[order[i]].stratum == "few" ? 1 : 0;
  }
  EXPECT_EQ(inFirstHalf, 2U);
}

TEST(CaseLabels, AreUniqueAndNewAndTheirOrderRevealsNothing) {
  const std::vector<std::string> labels = caseLabels(90, {"7F"}, 11, 1);

  const std::set<std::string> unique(labels.begin(), labels.end());
  EXPECT_EQ(unique.size(), 90U);
  EXPECT_FALSE(unique.contains("7F"));
  EXPECT_FALSE(std::is_sorted(labels.begin(), labels.end()));
  EXPECT_NE(labels, caseLabels(90, {"7F"}, 11, 2));
  for (const std::string& label : labels) {
    EXPECT_EQ(label.size(), 2U);
    EXPECT_EQ(label.find_first_of("IO"), std::string::npos);
  }
}

TEST(CaseLabels, GrowWhenTheShortOnesAreUsedUp) {
  // 9 digits x 24 letters = 216 short labels.
  const std::vector<std::string> labels = caseLabels(300, {}, 11, 1);

  EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()).size(), 300U);
  const auto lateShort = std::count_if(labels.end() - 100, labels.end(),
                                       [](const std::string& label) { return label.size() == 2; });
  EXPECT_GT(lateShort, 40);  // expected 72: long ones do not gather at the end
}

}  // namespace
}  // namespace torsio
