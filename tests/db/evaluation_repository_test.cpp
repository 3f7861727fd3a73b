// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/evaluation_repository.h"

#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/campaign.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/error.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

class EvaluationRepositoryTest : public SampleTest {
 protected:
  EvaluationRepository evaluations() { return EvaluationRepository(connection()); }
  /// The paper's nine indices, two chiefs as the only raters, two models.
  static Campaign campaignFor(SampleRecord& sample) {
    Campaign campaign;
    campaign.id = sample.ids.newUuid();
    campaign.name = "Evaluation";
    campaign.instrument = paperInstrument();
    campaign.instrument.classes = {{"intern", "interns", 200},
                                   {"deputy_chief", "deputy chief physicians", 300},
                                   {"chief", "chief physicians", 500}};
    campaign.models = {{"PM", "proposed model", "Y", 1}, {"FEM", "finite elements", "X", 2}};
    for (const Rater& chief : sample.chiefs) {
      campaign.raters.push_back({chief.person.id, "chief", "FEM,PM"});
    }
    campaign.createdUtc_us = kSampleTime_us;
    campaign.demonstration = true;
    return campaign;
  }
  Campaign addedCampaign() {
    Campaign campaign = campaignFor(sample());
    evaluations().addCampaign(campaign);
    return campaign;
  }
  static EvaluationMark markOf(SampleRecord& sample, std::size_t rater, const std::string& model,
                               std::int64_t index, std::int64_t score_steps) {
    EvaluationMark mark;
    mark.id = sample.ids.newUuid();
    mark.raterId = sample.chiefs[rater].person.id;
    mark.modelCode = model;
    mark.indexNumber = index;
    mark.score_steps = score_steps;
    mark.submittedUtc_us = kSampleTime_us;
    mark.demonstration = true;
    return mark;
  }
};

TEST_F(EvaluationRepositoryTest, ReturnsACampaignAsStored) {
  const Campaign planned = campaignFor(sample());

  evaluations().addCampaign(planned);

  const Campaign stored = evaluations().campaign(planned.id).value();
  ASSERT_EQ(stored.instrument.indices.size(), 9U);
  EXPECT_EQ(stored.instrument.indices[8].weight_milli, 50);
  EXPECT_EQ(stored.instrument.indices[0].name, planned.instrument.indices[0].name);
  ASSERT_EQ(stored.instrument.classes.size(), 3U);
  EXPECT_EQ(stored.instrument.classes[2].id, "chief");
  EXPECT_EQ(stored.instrument.classes[2].weight_milli, 500);
  EXPECT_EQ(stored.instrument.scale.stepsPerPoint, planned.instrument.scale.stepsPerPoint);
  ASSERT_EQ(stored.models.size(), 2U);
  EXPECT_EQ(stored.models[1].hiddenLabel, "X");
  ASSERT_EQ(stored.raters.size(), 2U);
  EXPECT_EQ(stored.raters[0].modelOrder, "FEM,PM");
  EXPECT_TRUE(stored.demonstration);
  EXPECT_EQ(evaluations().campaigns().at(0).second, "Evaluation");
  EXPECT_FALSE(evaluations().campaign("none").has_value());
}

TEST_F(EvaluationRepositoryTest, RefusesWeightsThatDoNotSumToOne) {
  Campaign campaign = campaignFor(sample());
  campaign.instrument.classes[0].weight_milli = 201;

  EXPECT_EQ(refusalFrom([&] { EvaluationRepository(connection()).addCampaign(campaign); }).code,
            ErrorCode::kBadParameter);
}

TEST_F(EvaluationRepositoryTest, ReturnsMarksByModelClassRaterAndIndex) {
  const Campaign campaign = addedCampaign();
  std::vector<EvaluationMark> marks;
  for (const char* model : {"FEM", "PM"}) {
    for (std::size_t rater = 0; rater < 2; ++rater) {
      for (std::int64_t index = 9; index >= 1; --index) {
        marks.push_back(markOf(sample(), rater, model, index, 10 * index + static_cast<std::int64_t>(rater)));
      }
    }
  }

  evaluations().submit(campaign.id, marks);

  const std::vector<EvaluationMark> stored = evaluations().marks(campaign.id);
  ASSERT_EQ(stored.size(), 36U);
  EXPECT_EQ(stored[0].modelCode, "PM");
  EXPECT_EQ(stored[0].raterCode, "C-01");
  EXPECT_EQ(stored[0].classCode, "chief");
  EXPECT_EQ(stored[0].indexNumber, 1);
  EXPECT_EQ(stored[0].score_steps, 10);
  EXPECT_EQ(stored[17].score_steps, 91);
  EXPECT_EQ(stored[18].modelCode, "FEM");
}

TEST_F(EvaluationRepositoryTest, RejectsAScoreOffTheScaleNamingRaterModelAndIndex) {
  const Campaign campaign = addedCampaign();

  const Refusal refusal = refusalFrom([&] {
    evaluations().submit(campaign.id, std::vector<EvaluationMark>{markOf(sample(), 0, "PM", 1, 50),
                                                                  markOf(sample(), 0, "PM", 2, 101)});
  });

  EXPECT_EQ(refusal.code, ErrorCode::kBadData);
  EXPECT_NE(refusal.text.find("index 2"), std::string::npos) << refusal.text;
  EXPECT_TRUE(evaluations().marks(campaign.id).empty());
}

TEST_F(EvaluationRepositoryTest, RejectsMarksOfUnknownRatersAndModels) {
  const Campaign campaign = addedCampaign();
  EvaluationMark stranger = markOf(sample(), 0, "PM", 1, 50);
  stranger.raterId = sample().trainees[0].person.id;
  const std::vector<EvaluationMark> wrong[] = {
      {stranger}, {markOf(sample(), 0, "MSM", 1, 50)}, {markOf(sample(), 0, "PM", 10, 50)}};

  for (const std::vector<EvaluationMark>& marks : wrong) {
    EXPECT_EQ(faultFrom([&] { evaluations().submit(campaign.id, marks); }), DbFault::kForeignKey);
  }
}

TEST_F(EvaluationRepositoryTest, MarksAreSealedAndCorrectedByVersions) {
  const Campaign campaign = addedCampaign();
  evaluations().submit(campaign.id, std::vector<EvaluationMark>{markOf(sample(), 0, "PM", 1, 50)});
  EvaluationMark better = markOf(sample(), 0, "PM", 1, 60);
  EXPECT_EQ(faultFrom([&] { evaluations().submit(campaign.id, std::vector<EvaluationMark>{better}); }),
            DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE evaluation_mark SET score_steps = ?", {60}); }),
            DbFault::kAppendOnly);

  better.version = 2;
  better.amendReason = "mixed up two models";
  evaluations().submit(campaign.id, std::vector<EvaluationMark>{better});

  ASSERT_EQ(evaluations().marks(campaign.id).size(), 1U);
  EXPECT_EQ(evaluations().marks(campaign.id)[0].score_steps, 60);
}

TEST_F(EvaluationRepositoryTest, ABatchRepeatedAfterALostAnswerIsStoredOnce) {
  const Campaign campaign = addedCampaign();
  std::vector<EvaluationMark> marks{markOf(sample(), 0, "PM", 1, 50), markOf(sample(), 0, "PM", 2, 60)};
  evaluations().submit(campaign.id, std::span(marks.data(), 1));

  evaluations().submit(campaign.id, marks);
  evaluations().submit(campaign.id, marks);

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM evaluation_mark"), 2);
  EXPECT_EQ(AuditRepository(connection()).count(0), 2);
  marks[0].score_steps = 51;
  EXPECT_EQ(faultFrom([&] { evaluations().submit(campaign.id, marks); }), DbFault::kUnique);
}

TEST_F(EvaluationRepositoryTest, EveryRunIsKeptWithItsResults) {
  const Campaign campaign = addedCampaign();
  EvaluationRunRows run;
  run.run.formulaVersion = "evaluation-1";
  run.run.policy = "available-case";
  run.run.flags = {"available-case"};
  for (int i = 0; i < 2; ++i) {
    run.run.id = sample().ids.newUuid();
    run.run.computedUtc_us = kSampleTime_us + i;
    run.results = {{.modelCode = "PM",
                    .indexNumber = 1,
                    .weightedMean = 8.3,
                    .variance = 0.99 + i,
                    .raterCount = 40,
                    .missingCount = 0,
                    .lowest = 7,
                    .highest = 9,
                    .plainMean = 7.75,
                    .populationVariance = 0.6875,
                    .sampleVariance = std::nullopt,
                    .standardError = 0.125,
                    .flags = {}}};
    run.composites = {{"PM", 8.3, std::nullopt, {"few raters"}}};
    evaluations().storeRun(campaign.id, run);
  }

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM assessment_run"), 2);
  Statement result = connection().prepare(
      "SELECT weighted_mean, variance, sample_variance, standard_error FROM evaluation_result"
      " WHERE run_id = ?");
  result.execute({run.run.id});
  ASSERT_TRUE(result.step());
  EXPECT_EQ(result.real(0), 8.3);
  EXPECT_EQ(result.real(1), 0.99 + 1);
  EXPECT_TRUE(result.isNull(2));
  EXPECT_EQ(result.real(3), 0.125);
  Statement composite =
      connection().prepare("SELECT composite, flags FROM composite_result WHERE run_id = ?");
  composite.execute({run.run.id});
  ASSERT_TRUE(composite.step());
  EXPECT_EQ(composite.real(0), 8.3);
  EXPECT_EQ(composite.text(1), "few raters");
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE composite_result SET composite = ?", {9.9}); }),
            DbFault::kAppendOnly);
}

}  // namespace
}  // namespace torsio
