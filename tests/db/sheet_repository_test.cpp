// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/sheet_repository.h"

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "sim/core/error.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

class SheetRepositoryTest : public DatabaseTest {
 protected:
  /// A rubric of two rows and an overall mark from 1 to 10; both chiefs are assigned to every trainee, "pre".
  struct Desk {
    explicit Desk(Connection& connection, int trainees = 1)
        : sample(connection, trainees), sheets(connection) {
      RubricRepository rubrics(connection);
      const RubricId rubricId = sample.ids.newUuid();
      rubrics.addRubric(rubricId, "Twist", kSampleTime_us, true);
      rubric = {.id = sample.ids.newUuid(), .rubricId = rubricId};
      rubric.overall = {10, 100, 10};
      rubric.rows = {{"time", "training time", {10, 100, 10}, {{10, "very slow"}, {100, "as an expert"}}},
                     {"accuracy", "operational accuracy", {0, 5, 1}, {}}};
      rubric.createdBy = "admin";
      rubric.createdUtc_us = kSampleTime_us;
      rubrics.addRevision(rubric);
      for (std::size_t rater = 0; rater < 2; ++rater) {
        for (std::size_t trainee = 0; trainee < sample.enrolments.size(); ++trainee) {
          Assignment assignment;
          assignment.id = sample.ids.newUuid();
          assignment.raterId = sample.chiefs[rater].person.id;
          assignment.enrolmentId = sample.enrolments[trainee].id;
          assignment.occasionCode = "pre";
          assignment.rubricRevisionId = rubric.id;
          assignment.caseLabel = std::to_string(trainee) + "F";
          assignment.position = -static_cast<std::int64_t>(trainee);
          assignment.assignedBy = "admin";
          assignment.assignedUtc_us = kSampleTime_us;
          assignments.push_back(assignment);
        }
      }
      sheets.assign(assignments);
    }
    SampleRecord sample;
    SheetRepository sheets;
    RubricRevision rubric;
    std::vector<Assignment> assignments;
  };

  static Sheet fullSheet() {
    return {.revision = 0,
            .overall_steps = 75,
            .notAssessableReason = "",
            .comment = "calm",
            .rows = {{"accuracy", 4, ""}, {"time", std::nullopt, "clock failed"}},
            .changedUtc_us = kSampleTime_us};
  }
};

TEST_F(SheetRepositoryTest, ReturnsARubricRevisionWithItsAnchors) {
  const Desk desk(connection());

  const RubricRevision stored = RubricRepository(connection()).revision(desk.rubric.id).value();

  ASSERT_EQ(stored.rows.size(), 2U);
  EXPECT_EQ(stored.rows[0].code, "time");
  ASSERT_EQ(stored.rows[0].anchors.size(), 2U);
  EXPECT_EQ(stored.rows[0].anchors[1].meaning, "as an expert");
  EXPECT_EQ(stored.rows[1].scale.hi, 5);
  EXPECT_EQ(stored.overall.lo, 10);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE rubric_row SET label = ?", {"x"}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM rubric_anchor"); }), DbFault::kAppendOnly);
}

TEST_F(SheetRepositoryTest, TheQueueHasTheRatersOrderAndTheStates) {
  Desk desk(connection(), 3);
  desk.sheets.saveDraft(desk.assignments[1].id, {.revision = 0, .overall_steps = 50});
  desk.sheets.submit(desk.assignments[2].id, desk.sample.ids.newUuid(), fullSheet(), "", kSampleTime_us);

  const std::vector<QueueEntry> queue = desk.sheets.queue(desk.sample.chiefs[0].person.id);

  ASSERT_EQ(queue.size(), 3U);
  EXPECT_EQ(queue[0].caseLabel, "2F");
  EXPECT_EQ(queue[0].state, SheetState::kSubmitted);
  EXPECT_EQ(queue[1].state, SheetState::kDraft);
  EXPECT_EQ(queue[2].state, SheetState::kOpen);
}

TEST_F(SheetRepositoryTest, SavesDraftsWithoutOverwritingAnotherStations) {
  Desk desk(connection());
  const std::string id = desk.assignments[0].id;
  Sheet sheet{.revision = 0, .overall_steps = std::nullopt, .rows = {{"time", 70, ""}}};
  sheet.revision = desk.sheets.saveDraft(id, sheet);
  sheet.rows.push_back({"accuracy", std::nullopt, ""});
  sheet.comment = "slow start";
  sheet.revision = desk.sheets.saveDraft(id, sheet);

  Connection other = open();
  const Sheet read = SheetRepository(other).draft(id).value();
  EXPECT_EQ(read.revision, 2);
  EXPECT_EQ(read.comment, "slow start");
  ASSERT_EQ(read.rows.size(), 2U);
  EXPECT_FALSE(read.rows[0].score_steps.has_value());
  EXPECT_EQ(read.rows[1].score_steps, 70);
  SheetRepository(other).saveDraft(id, read);
  EXPECT_EQ(faultFrom([&] { desk.sheets.saveDraft(id, sheet); }), DbFault::kConflict);
}

TEST_F(SheetRepositoryTest, SubmittingSealsTheSheetAndDeletesTheDraft) {
  Desk desk(connection());
  const std::string id = desk.assignments[0].id;
  desk.sheets.saveDraft(id, {.revision = 0, .overall_steps = 20});

  desk.sheets.submit(id, desk.sample.ids.newUuid(), fullSheet(), "", kSampleTime_us);

  EXPECT_FALSE(desk.sheets.draft(id).has_value());
  const Sheet sealed = desk.sheets.submitted(id).value();
  EXPECT_EQ(sealed.overall_steps, 75);
  ASSERT_EQ(sealed.rows.size(), 2U);
  EXPECT_EQ(sealed.rows[0].score_steps, 4);
  EXPECT_EQ(sealed.rows[1].notAssessableReason, "clock failed");
  EXPECT_EQ(RatingRepository(connection()).marks(desk.sample.cohort.id).at(0).assignmentId, id);
  EXPECT_EQ(refusalFrom([&] { desk.sheets.saveDraft(id, fullSheet()); }).code, ErrorCode::kBadData);
  EXPECT_EQ(
      faultFrom([&] { desk.sheets.submit(id, desk.sample.ids.newUuid(), fullSheet(), "", kSampleTime_us); }),
      DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE training_mark_row SET score_steps = ?", {5}); }),
            DbFault::kAppendOnly);
}

TEST_F(SheetRepositoryTest, AnAmendmentIsTheNextVersion) {
  Desk desk(connection());
  const std::string id = desk.assignments[0].id;
  desk.sheets.submit(id, desk.sample.ids.newUuid(), fullSheet(), "", kSampleTime_us);
  Sheet better = fullSheet();
  better.revision = 1;
  better.overall_steps = 80;

  desk.sheets.submit(id, desk.sample.ids.newUuid(), better, "looked again", kSampleTime_us + 1);

  EXPECT_EQ(desk.sheets.submitted(id)->overall_steps, 80);
  const SubmittedMark mark = RatingRepository(connection()).marks(desk.sample.cohort.id).at(0);
  EXPECT_EQ(mark.version, 2);
  EXPECT_EQ(mark.amendReason, "looked again");
}

TEST_F(SheetRepositoryTest, OfTwoAmendmentsOfOneVersionTheSecondIsToldAndKeepsNothing) {
  Desk desk(connection());
  const std::string id = desk.assignments[0].id;
  desk.sheets.submit(id, desk.sample.ids.newUuid(), fullSheet(), "", kSampleTime_us);
  const Sheet read = desk.sheets.submitted(id).value();
  EXPECT_EQ(read.revision, 1);
  desk.sheets.submit(id, desk.sample.ids.newUuid(), read, "looked again", kSampleTime_us + 1);

  EXPECT_EQ(faultFrom([&] {
              desk.sheets.submit(id, desk.sample.ids.newUuid(), read, "mistyped", kSampleTime_us + 2);
            }),
            DbFault::kConflict);

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM training_mark"), 2);
  EXPECT_EQ(desk.sheets.submitted(id)->revision, 2);
}

TEST_F(SheetRepositoryTest, SubmittingAgainAfterALostAnswerSealsOnce) {
  Desk desk(connection());
  const std::string id = desk.assignments[0].id;
  const std::string first = desk.sample.ids.newUuid();
  const std::string second = desk.sample.ids.newUuid();
  Sheet better = fullSheet();
  better.revision = 1;
  better.overall_steps = 80;
  desk.sheets.submit(id, first, fullSheet(), "", kSampleTime_us);
  desk.sheets.submit(id, second, better, "looked again", kSampleTime_us + 1);

  desk.sheets.submit(id, first, fullSheet(), "", kSampleTime_us + 2);
  desk.sheets.submit(id, second, better, "looked again", kSampleTime_us + 2);

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM training_mark"), 2);
  EXPECT_EQ(AuditRepository(connection()).count(0), 2);
  EXPECT_EQ(desk.sheets.submitted(id)->overall_steps, 80);
}

TEST_F(SheetRepositoryTest, RejectsAnotherSheetWithTheIdOfASealedOne) {
  Desk desk(connection());
  const std::string id = desk.assignments[0].id;
  const std::string mark = desk.sample.ids.newUuid();
  desk.sheets.submit(id, mark, fullSheet(), "", kSampleTime_us);

  Sheet otherScore = fullSheet();
  otherScore.overall_steps = 80;
  Sheet otherRow = fullSheet();
  otherRow.rows[0].score_steps = 5;
  Sheet otherComment = fullSheet();
  otherComment.comment = "hasty";
  for (const Sheet& other : {otherScore, otherRow, otherComment}) {
    EXPECT_EQ(faultFrom([&] { desk.sheets.submit(id, mark, other, "", kSampleTime_us); }), DbFault::kUnique);
  }
  const Refusal refusal = refusalFrom([&] { desk.sheets.submit(id, mark, otherRow, "", kSampleTime_us); });
  EXPECT_NE(refusal.text.find("this mark is already stored with different content"), std::string::npos)
      << refusal.text;
  EXPECT_EQ(desk.sheets.submitted(id)->overall_steps, 75);
}

TEST_F(SheetRepositoryTest, RejectsAnIncompleteSheetNamingTheRow) {
  Desk desk(connection());
  const auto refused = [&](const Sheet& sheet) {
    return refusalFrom([&] {
             desk.sheets.submit(desk.assignments[0].id, desk.sample.ids.newUuid(), sheet, "", kSampleTime_us);
           })
        .text;
  };
  Sheet missing = fullSheet();
  missing.rows.pop_back();
  EXPECT_NE(refused(missing).find("row time"), std::string::npos);
  Sheet outside = fullSheet();
  outside.rows[0].score_steps = 6;
  EXPECT_NE(refused(outside).find("row accuracy"), std::string::npos);
  Sheet unknown = fullSheet();
  unknown.rows.push_back({"style", 1, ""});
  EXPECT_NE(refused(unknown).find("style"), std::string::npos);
  Sheet unmarked = fullSheet();
  unmarked.overall_steps.reset();
  EXPECT_NE(refused(unmarked).find("overall"), std::string::npos);
  EXPECT_TRUE(RatingRepository(connection()).marks(desk.sample.cohort.id).empty());
}

TEST_F(SheetRepositoryTest, IsPrivateUntilAllHaveSubmitted) {
  Desk desk(connection());
  const std::string enrolment = desk.sample.enrolments[0].id;
  EXPECT_FALSE(desk.sheets.allSubmitted(enrolment, "pre"));
  desk.sheets.submit(desk.assignments[0].id, desk.sample.ids.newUuid(), fullSheet(), "", kSampleTime_us);
  EXPECT_FALSE(desk.sheets.allSubmitted(enrolment, "pre"));

  desk.sheets.withdraw(desk.assignments[1].id, "on leave", "admin", kSampleTime_us);

  EXPECT_TRUE(desk.sheets.allSubmitted(enrolment, "pre"));
  EXPECT_TRUE(desk.sheets.queue(desk.sample.chiefs[1].person.id).empty());
  EXPECT_EQ(refusalFrom([&] {
              desk.sheets.submit(desk.assignments[1].id, desk.sample.ids.newUuid(), fullSheet(), "", 0);
            }).code,
            ErrorCode::kBadData);
  EXPECT_EQ(refusalFrom([&] { desk.sheets.withdraw(desk.assignments[0].id, "", "admin", 0); }).code,
            ErrorCode::kBadData);
}

TEST_F(SheetRepositoryTest, AReturnedSheetKeepsItsDraftAndCanBeWithdrawnAgain) {
  Desk desk(connection());
  const AssignmentId id = desk.assignments[0].id;
  const std::string rater = desk.sample.chiefs[0].person.id;
  const std::size_t waiting = desk.sheets.queue(rater).size();
  static_cast<void>(desk.sheets.saveDraft(id, fullSheet()));
  desk.sheets.withdraw(id, "ill", "admin", kSampleTime_us);
  EXPECT_EQ(desk.sheets.queue(rater).size(), waiting - 1);
  EXPECT_EQ(refusalFrom([&] { desk.sheets.withdraw(id, "ill", "admin", 0); }).code, ErrorCode::kBadData);

  desk.sheets.giveBack(id, "well again", "admin", kSampleTime_us + 1);

  EXPECT_EQ(desk.sheets.queue(rater).size(), waiting);
  EXPECT_EQ(desk.sheets.findAssignment(id)->state, SheetState::kDraft);
  EXPECT_EQ(refusalFrom([&] { desk.sheets.giveBack(id, "", "admin", 0); }).code, ErrorCode::kBadData);
  desk.sheets.withdraw(id, "ill again", "admin", kSampleTime_us + 2);
  EXPECT_EQ(desk.sheets.findAssignment(id)->state, SheetState::kWithdrawn);
}

TEST_F(SheetRepositoryTest, ReleasesAndRevokesMarks) {
  Desk desk(connection());
  const std::string cohort = desk.sample.cohort.id;
  EXPECT_FALSE(desk.sheets.isReleased(cohort, "pre"));
  desk.sheets.setReleased(cohort, "pre", true, "all in", "admin", kSampleTime_us);
  EXPECT_TRUE(desk.sheets.isReleased(cohort, "pre"));
  EXPECT_FALSE(desk.sheets.isReleased(cohort, "mid"));
  desk.sheets.setReleased(cohort, "pre", false, "one was wrong", "admin", kSampleTime_us + 1);
  EXPECT_FALSE(desk.sheets.isReleased(cohort, "pre"));
}

}  // namespace
}  // namespace torsio
