// SPDX-License-Identifier: GPL-3.0-or-later
// Ten raters, one office and three stages on the real arm, each with a separate connection, and typical
// problems of such a day: a rater's machine dies, a call is made twice, an office has to sign in again.
#include <map>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "app/services/review/case_sheet.h"
#include "app/services/review/review_queue.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/live_call.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/system/audit_verification.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

constexpr std::size_t kRaters = 10;
constexpr std::size_t kTrainees = 6;
constexpr std::int64_t kPhase_us = 20 * 60'000'000LL;
constexpr const char* kRoom = "Skills lab";

class LiveSession : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    centre_ = std::make_unique<StudyCentre>(locator());
    const PaperStudy study = centre_->addStudy(kTrainees, kRaters);
    chiefs_ = study.chiefs;
    cohort_ = study.cohortId;
    enrolled_ = study.enrolmentIds;
    createAssignments(centre_->session(), study.plan(11));
    centre_->allocate(cohort_);
    office_ = openAdministrator();
    for (std::size_t i = 0; i < kRaters; ++i) {
      raters_.push_back(openDesk(i));
    }
  }
  void TearDown() override {
    raters_.clear();
    office_.reset();
    centre_.reset();
    DatabaseTest::TearDown();
  }

  /// Simulates a separate program: another connection to the same record.
  std::unique_ptr<SessionContext> openAs(Actor actor) {
    actor.passwordShownUtc_us = utcNow_us();  // on the day's clock
    return std::make_unique<SessionContext>(SessionKey{locator(), "desk of " + actor.login, actor});
  }
  std::unique_ptr<SessionContext> openAdministrator() { return openAs(centre_->as("administrator").actor()); }
  std::unique_ptr<SessionContext> openDesk(std::size_t rater) {
    return openAs(centre_->asRater(chiefs_[rater]).actor());
  }
  SessionContext& office() {
    office_->beginCall();
    return *office_;
  }
  SessionContext& desk(std::size_t rater) {
    raters_[rater]->beginCall();
    return *raters_[rater];
  }

  /// Returns the single sheet that the rater's page opens automatically.
  std::optional<QueueLine> calledSheet(std::size_t rater) {
    std::optional<QueueLine> found;
    for (const QueueLine& line : liveLines(desk(rater))) {
      if (line.call && line.call->open && line.state != SheetState::kSubmitted) {
        EXPECT_FALSE(found.has_value()) << "two sheets are called at once";
        found = line;
      }
    }
    return found;
  }
  static Sheet filled(const OpenedSheet& opened, std::int64_t steps) {
    Sheet sheet = opened.sheet;
    sheet.overall_steps = steps;
    sheet.rows.clear();
    for (const RubricLine& row : opened.rubric.rows) {
      sheet.rows.push_back({row.code, steps, ""});
    }
    return sheet;
  }
  void submitCalled(std::size_t rater, const std::string& label, std::int64_t steps) {
    const std::optional<QueueLine> line = calledSheet(rater);
    ASSERT_TRUE(line.has_value()) << "rater " << rater;
    EXPECT_EQ(line->shown.label, label);
    const AssignmentId id = line->shown.assignmentId;
    const OpenedSheet opened = openSheet(desk(rater), id);
    submitSheet(desk(rater), id, filled(opened, steps), WatchLog());
  }
  LiveCallId call(std::size_t trainee) {
    return callTrainee(office(), {cohort_, enrolled_[trainee], {}, kRoom, {}});
  }
  CalledCase now() { return calledCases(office(), cohort_).front(); }
  void scoreByAll(std::size_t trainee, std::int64_t steps) {
    const LiveCallId id = call(trainee);
    const std::string label = now().caseLabel;
    for (std::size_t rater = 0; rater < kRaters; ++rater) {
      submitCalled(rater, label, steps);
    }
    EXPECT_EQ(now().submitted, kRaters);
    endCall(office(), cohort_, id);
    for (const CalledCase& late : calledCases(office(), cohort_)) {
      EXPECT_NE(late.call.id, id) << "all sheets are in";
    }
  }
  void scoreByAllBut4(std::size_t trainee) {
    const LiveCallId id = call(trainee);
    const std::string label = now().caseLabel;
    for (std::size_t rater = 0; rater < kRaters; ++rater) {
      if (rater != 4) {
        submitCalled(rater, label, 50);
      }
    }
    endCall(office(), cohort_, id);
  }
  void trainAll() {
    for (const DayBoardRow& row : dayBoard(office(), cohort_).rows) {
      const ExposureKind kind =
          row.unplanned == std::vector{ExposureKind::kVirtual} ? ExposureKind::kReal : ExposureKind::kVirtual;
      recordExposure(office(), {cohort_, row.enrolmentId, "", kind, office().now_us(), kPhase_us});
    }
  }

  std::unique_ptr<StudyCentre> centre_;
  std::vector<RaterId> chiefs_;
  CohortId cohort_;
  std::vector<EnrolmentId> enrolled_;
  std::unique_ptr<SessionContext> office_;
  std::vector<std::unique_ptr<SessionContext>> raters_;
};

TEST_F(LiveSession, TenRatersScoreSixTraineesAtThreeStagesGuidedByCalls) {
  for (int stage = 0; stage < 3; ++stage) {
    for (std::size_t trainee = 0; trainee < kTrainees; ++trainee) {
      scoreByAll(trainee, 40 + 10 * stage);
    }
    if (stage < 2) {
      trainAll();
    }
  }

  // Each mark is on the sheet of the stage at which the trainee was called.
  const std::map<std::string, std::int64_t> stepsOf{{"pre", 40}, {"mid", 50}, {"post", 60}};
  std::size_t marks = 0;
  for (const AssignmentStatus& status : SheetRepository(centre_->connection()).assignments(cohort_)) {
    EXPECT_EQ(status.state, SheetState::kSubmitted);
    const auto sheet = SheetRepository(centre_->connection()).submitted(status.assignment.id);
    ASSERT_TRUE(sheet.has_value());
    EXPECT_EQ(sheet->overall_steps, stepsOf.at(status.assignment.occasionCode));
    ++marks;
  }
  EXPECT_EQ(marks, kRaters * kTrainees * 3);
  EXPECT_EQ(CallRepository(centre_->connection()).calls(cohort_).size(), kTrainees * 3);
  EXPECT_TRUE(deviations(office(), cohort_).empty());
  EXPECT_TRUE(verifyAuditTrail(centre_->connection()).empty());
}

TEST_F(LiveSession, ARaterWhoseMachineDiesSubmitsTheSheetAfterTheCall) {
  const LiveCallId id = call(2);
  const std::string label = now().caseLabel;
  for (std::size_t rater = 0; rater < kRaters; ++rater) {
    if (rater != 4) {
      submitCalled(rater, label, 50);
    }
  }
  const AssignmentId sheet = calledSheet(4)->shown.assignmentId;
  saveSheet(desk(4), sheet, {.overall_steps = 30}, WatchLog());
  raters_[4].reset();  // the machine is off
  endCall(office(), cohort_, id);
  scoreByAllBut4(3);

  const std::vector<CalledCase> late = calledCases(office(), cohort_);
  ASSERT_EQ(late.size(), 2U);
  EXPECT_EQ(late[0].caseLabel, label);
  EXPECT_EQ(late[0].missing, (std::vector<std::string>{"R-05"}));

  raters_[4] = openDesk(4);
  EXPECT_FALSE(calledSheet(4).has_value()) << "nobody stands at the arm";
  const std::vector<QueueLine> lines = liveLines(desk(4));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].state, SheetState::kDraft);
  EXPECT_EQ(reviewQueue(desk(4)).overdue, 2U) << "the first page counts what the live board calls late";
  const OpenedSheet opened = openSheet(desk(4), sheet);
  EXPECT_EQ(opened.sheet.overall_steps, 30) << "what was typed before the machine died";
  submitSheet(desk(4), sheet, filled(opened, 30), WatchLog());
  EXPECT_EQ(calledCases(office(), cohort_).size(), 1U);
}

TEST_F(LiveSession, AnAdministratorWhoSignsInAgainFindsTheCallAndDoesNotRepeatIt) {
  const LiveCallId id = call(1);
  std::unique_ptr<SessionContext> second = openAdministrator();
  EXPECT_EQ(callTrainee(*second, {cohort_, enrolled_[1], {}, kRoom, {}}), id);
  second->beginCall();
  EXPECT_THROW(callTrainee(*second, {cohort_, enrolled_[0], {}, kRoom, {}}), Error);
  office_.reset();  // the station is lost
  office_ = std::move(second);
  EXPECT_EQ(now().call.id, id);
  endCall(office(), cohort_, id);
  EXPECT_EQ(CallRepository(centre_->connection()).calls(cohort_).size(), 1U);
  EXPECT_FALSE(calledSheet(0).has_value());
  scoreByAll(0, 50);
}

TEST_F(LiveSession, AWrongScanCanBeCancelledAndLeavesNoSheetOpen) {
  const LiveCallId wrong = call(5);
  saveSheet(desk(7), calledSheet(7)->shown.assignmentId, {.overall_steps = 20}, WatchLog());
  cancelCall(office(), cohort_, wrong, "T-01 stood there");
  for (std::size_t rater = 0; rater < kRaters; ++rater) {
    EXPECT_FALSE(calledSheet(rater).has_value());
  }
  scoreByAll(0, 50);
  EXPECT_TRUE(verifyAuditTrail(centre_->connection()).empty());
}

}  // namespace
}  // namespace torsio
