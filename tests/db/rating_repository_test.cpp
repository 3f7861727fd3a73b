// SPDX-License-Identifier: GPL-3.0-or-later

#include "db/repository/rating/rating_repository.h"

#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/freeze_repository.h"
#include "tests/db/sample_record.h"

namespace torsio {

namespace {

class RatingRepositoryTest : public SampleTest {
 protected:
  RatingRepository ratings() { return RatingRepository(connection()); }
  static SubmittedMark markOf(SampleRecord& sample, std::size_t trainee, std::size_t rater,
                              const std::string& point, std::int64_t score_steps) {
    SubmittedMark mark;
    mark.id = sample.ids.newUuid();
    mark.enrolmentId = sample.enrolments[trainee].id;
    mark.raterId = sample.chiefs[rater].person.id;
    mark.occasionCode = point;
    mark.score_steps = score_steps;
    mark.submittedUtc_us = kSampleTime_us;
    mark.demonstration = true;
    return mark;
  }
};

TEST_F(RatingRepositoryTest, ReturnsMarksWithCodesByOccasion) {
  SampleRecord sample(connection(), 2);
  std::vector<SubmittedMark> marks;
  for (const char* point : {"post", "pre", "mid"}) {
    for (std::size_t trainee = 0; trainee < 2; ++trainee) {
      marks.push_back(markOf(sample, trainee, 1, point, 55));
      marks.push_back(markOf(sample, trainee, 0, point, 73));
    }
  }
  marks[0].comment = "steady hand";

  ratings().submit(marks);

  const std::vector<SubmittedMark> stored = ratings().marks(sample.cohort.id);
  ASSERT_EQ(stored.size(), 12U);
  EXPECT_EQ(stored[0].occasionCode, "pre");
  EXPECT_EQ(stored[0].traineeCode, "T-01");
  EXPECT_EQ(stored[0].raterCode, "C-01");
  EXPECT_EQ(stored[0].score_steps, 73);
  EXPECT_EQ(stored[0].scale.hi, 100);
  EXPECT_TRUE(stored[0].demonstration);
  EXPECT_EQ(stored[9].occasionCode, "post");
  EXPECT_EQ(stored[9].comment, "steady hand");
}

TEST_F(RatingRepositoryTest, ACorrectionIsANewVersionWithItsReason) {
  ratings().submit(std::vector<SubmittedMark>{markOf(sample(), 0, 0, "pre", 40)});
  SubmittedMark better = markOf(sample(), 0, 0, "pre", 45);
  better.version = 2;
  EXPECT_EQ(faultFrom([&] { ratings().submit(std::vector<SubmittedMark>{better}); }), DbFault::kCheck);

  better.amendReason = "typed the wrong key";
  ratings().submit(std::vector<SubmittedMark>{better});

  EXPECT_EQ(ratings().marks(sample().cohort.id).size(), 1U);
  EXPECT_EQ(ratings().marks(sample().cohort.id)[0].score_steps, 45);
  const auto history = ratings().history(better.enrolmentId, better.raterId, "pre");
  ASSERT_EQ(history.size(), 2U);
  EXPECT_EQ(history[0].score_steps, 40);
  EXPECT_EQ(history[1].amendReason, "typed the wrong key");
}

TEST_F(RatingRepositoryTest, RefusesADuplicateVersion) {
  ratings().submit(std::vector<SubmittedMark>{markOf(sample(), 0, 0, "pre", 40)});

  Connection station = open();
  EXPECT_EQ(faultFrom([&] {
              RatingRepository(station).submit(std::vector<SubmittedMark>{markOf(sample(), 0, 0, "pre", 90)});
            }),
            DbFault::kUnique);
  EXPECT_EQ(ratings().marks(sample().cohort.id)[0].score_steps, 40);
}

TEST_F(RatingRepositoryTest, AMarkIsAScoreOnItsScaleOrAReason) {
  SubmittedMark mark = markOf(sample(), 0, 0, "pre", 101);
  EXPECT_EQ(faultFrom([&] { ratings().submit(std::vector<SubmittedMark>{mark}); }), DbFault::kCheck);
  mark.score_steps.reset();
  EXPECT_EQ(faultFrom([&] { ratings().submit(std::vector<SubmittedMark>{mark}); }), DbFault::kCheck);

  mark.notAssessableReason = "camera failed";
  ratings().submit(std::vector<SubmittedMark>{mark});

  EXPECT_FALSE(ratings().marks(sample().cohort.id)[0].score_steps.has_value());
  EXPECT_EQ(ratings().marks(sample().cohort.id)[0].notAssessableReason, "camera failed");
}

TEST_F(RatingRepositoryTest, StoresNoMarkOfABatchWithAnInvalidOne) {
  SampleRecord sample(connection(), 2);
  std::vector<SubmittedMark> marks{markOf(sample, 0, 0, "pre", 50), markOf(sample, 1, 0, "never", 50)};

  EXPECT_EQ(faultFrom([&] { RatingRepository(connection()).submit(marks); }), DbFault::kForeignKey);
  EXPECT_TRUE(RatingRepository(connection()).marks(sample.cohort.id).empty());
}

TEST_F(RatingRepositoryTest, SubmittedMarksAreSealed) {
  RatingRepository(connection()).submit(std::vector<SubmittedMark>{markOf(sample(), 0, 0, "pre", 40)});

  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE training_mark SET score_steps = ?", {100}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM training_mark"); }), DbFault::kAppendOnly);
}

TEST_F(RatingRepositoryTest, ResultsCarryTheirFormulaAndFlags) {
  TrainingRunRows run;
  run.run = {.id = sample().ids.newUuid(),
             .formulaVersion = "training-1",
             .policy = "available-case",
             .inputsHash = "abc",
             .flags = {"available-case", "demonstration data"},
             .softwareVersion = "0.1.0",
             .computedUtc_us = kSampleTime_us,
             .demonstration = true};
  run.trainees = {{sample().enrolments[0].id, "pre", 7.0 / 3.0, 0.1, 2, 1, {"available-case"}}};
  run.groups = {{sample().groups[0].id, "pre", 1, 7.0 / 3.0, 0.0, std::nullopt, {}}};

  ratings().storeRun(sample().cohort.id, run);

  Statement stored = connection().prepare(
      "SELECT formula_version, flags, inputs_hash FROM assessment_run WHERE cohort_id = ?");
  stored.execute({sample().cohort.id});
  ASSERT_TRUE(stored.step());
  EXPECT_EQ(stored.text(0), "training-1");
  EXPECT_EQ(stored.text(1), "available-case;demonstration data");
  EXPECT_EQ(stored.text(2), "abc");
  Statement trainee = connection().prepare("SELECT mean, missing_count, flags FROM training_result");
  trainee.execute();
  ASSERT_TRUE(trainee.step());
  EXPECT_EQ(trainee.real(0), 7.0 / 3.0);
  EXPECT_EQ(trainee.int64(1), 1);
  EXPECT_EQ(trainee.text(2), "available-case");
  EXPECT_FALSE(trainee.step());
  Statement group = connection().prepare("SELECT variance_n_minus_1, flags FROM training_group_result");
  group.execute();
  ASSERT_TRUE(group.step());
  EXPECT_TRUE(group.isNull(0));
  EXPECT_EQ(group.text(1), "");
  EXPECT_FALSE(group.step());
}

}  // namespace

namespace {

class DiscrepancyRepositoryTest : public SampleTest {
 protected:
  static std::string assignmentIn(Connection& connection, SampleRecord& sample) {
    SheetRepository sheets(connection);
    RubricRepository rubrics(connection);
    rubrics.addRubric("rubric", "Twist", kSampleTime_us, true);
    RubricRevision revision{.id = "revision", .rubricId = "rubric"};
    revision.overall = {10, 100, 10};
    rubrics.addRevision(revision);
    Assignment assignment{.id = sample.ids.newUuid()};
    assignment.raterId = sample.chiefs[0].person.id;
    assignment.enrolmentId = sample.enrolments[0].id;
    assignment.occasionCode = "mid";
    assignment.rubricRevisionId = "revision";
    assignment.caseLabel = "7F";
    sheets.assign(std::span(&assignment, 1));
    return assignment.id;
  }
};

TEST_F(DiscrepancyRepositoryTest, TheNewestDecisionCountsAndAllAreKept) {
  const std::string id = assignmentIn(connection(), sample());
  DiscrepancyRepository decisions(connection(), "room 1");

  EXPECT_FALSE(decisions.latest(id).has_value());
  EXPECT_EQ(decisions.add({id, 0, DiscrepancyChoice::kThird, "far apart", "admin", kSampleTime_us}), 1);
  EXPECT_EQ(decisions.add({id, 0, DiscrepancyChoice::kKeep, "looked again", "chief", kSampleTime_us + 1}), 2);

  ASSERT_EQ(decisions.history(id).size(), 2U);
  EXPECT_EQ(decisions.history(id)[0].reason, "far apart");
  EXPECT_EQ(decisions.latest(id)->choice, DiscrepancyChoice::kKeep);
  ASSERT_EQ(decisions.ofCohort(sample().cohort.id).size(), 1U);
  EXPECT_EQ(decisions.ofCohort(sample().cohort.id)[0].sequence, 2);
  EXPECT_TRUE(decisions.ofCohort("another").empty());
  const AuditEntry entry = AuditRepository(connection()).entries().at(0);
  EXPECT_EQ(entry.action, "alignment.keep");
  EXPECT_EQ(entry.station, "room 1");
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM alignment_decision"); }), DbFault::kAppendOnly);
}

TEST_F(DiscrepancyRepositoryTest, RejectsInvalidDecisionsWithoutAnEntry) {
  const std::string id = assignmentIn(connection(), sample());
  DiscrepancyRepository decisions(connection());
  EXPECT_EQ(faultFrom([&] {
              decisions.add({"none", 0, DiscrepancyChoice::kKeep, "", "admin", 0});
            }),
            DbFault::kForeignKey);
  EXPECT_TRUE(AuditRepository(connection()).entries().empty());
}

class FreezeRepositoryTest : public SampleTest {};

TEST_F(FreezeRepositoryTest, AFrozenDataSetIsFoundByNameAndImmutable) {
  FreezeRepository freezes(connection(), "room 1");
  const DataFreeze freeze{sample().ids.newUuid(), sample().cohort.id,
                          "Autumn, final",        "0a1b",
                          R"({"marks":12})",      "admin",
                          kSampleTime_us,         true};

  freezes.add(freeze);
  freezes.add(freeze);

  ASSERT_EQ(freezes.list(sample().cohort.id).size(), 1U);
  const DataFreeze found = freezes.findByName("Autumn, final").value();
  EXPECT_EQ(found.id, freeze.id);
  EXPECT_EQ(found.contentHash, "0a1b");
  EXPECT_EQ(found.manifestJson, R"({"marks":12})");
  EXPECT_EQ(found.createdUtc_us, kSampleTime_us);
  EXPECT_FALSE(freezes.findByName("Spring").has_value());
  EXPECT_EQ(AuditRepository(connection()).entries().size(), 1U);
  DataFreeze other = freeze;
  other.contentHash = "ffff";
  EXPECT_EQ(faultFrom([&] { freezes.add(other); }), DbFault::kUnique);
  other.id = sample().ids.newUuid();
  EXPECT_EQ(faultFrom([&] { freezes.add(other); }), DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE frozen_dataset SET name = ?", {"x"}); }),
            DbFault::kAppendOnly);
}

}  // namespace

}  // namespace torsio
