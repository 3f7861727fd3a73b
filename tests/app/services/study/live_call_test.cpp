// SPDX-License-Identifier: GPL-3.0-or-later
// The office calls a trainee to the real arm, which opens the sheets of all raters.
#include "app/services/study/live_call.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "app/services/access/audit_service.h"
#include "app/services/people/consent_service.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/review_queue.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/open_sheets.h"
#include "app/services/study/paper_sheets.h"
#include "app/services/study/scoring_plan.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/run_session.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/sheet_check.h"
#include "db/connection/db_error.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

constexpr const char* kRoom = "Skills lab";

/// Four trainees with the paper's curriculum, three chiefs assigned to live sheets at all three occasions.
class LiveDay : public ::testing::Test {
 protected:
  void SetUp() override {
    const PaperStudy study = centre.addStudy(4, 3);
    trainees = study.trainees;
    chiefs = study.chiefs;
    cohort = study.cohortId;
    enrolled = study.enrolmentIds;
    createAssignments(centre.session(), study.plan());
  }

  SessionContext& office() { return centre.as("administrator"); }
  CallRequest request(std::size_t trainee, const std::string& occasion = {}, const std::string& reason = {},
                      const std::string& room = kRoom) {
    return {cohort, enrolled[trainee], occasion, room, reason};
  }
  void train(std::size_t trainee, std::int64_t minutes) {
    recordExposure(office(),
                   {cohort, enrolled[trainee], "", ExposureKind::kVirtual, 0, minutes * kMinute_us});
  }
  std::vector<QueueLine> linesOf(std::size_t chief) { return liveLines(centre.asRater(chiefs[chief])); }
  AssignmentId sheetOf(std::size_t chief, std::size_t trainee, const std::string& occasion) {
    for (const Assignment& one : SheetRepository(centre.connection()).assignmentsOf(chiefs[chief])) {
      if (one.enrolmentId == enrolled[trainee] && one.occasionCode == occasion) {
        return one.id;
      }
    }
    return {};
  }
  void score(std::size_t chief, std::size_t trainee, const std::string& occasion) {
    const AssignmentId id = sheetOf(chief, trainee, occasion);
    const OpenedSheet opened = openSheet(centre.asRater(chiefs[chief]), id);
    submitSheet(centre.session(), id, evenSheet(opened.rubric, 70, 70), WatchLog());
  }
  /// Signs in a second administrator.
  SessionContext& colleague() {
    if (colleague_.empty()) {
      colleague_ = centre.session().ids().newUuid();
      AccessRepository(centre.connection(), PasswordCost::kTest)
          .addUser({.id = colleague_, .login = "colleague", .createdUtc_us = 1, .roles = {"administrator"}},
                   "ten signs and more");
    }
    centre.session().setActor({.userId = colleague_, .login = "colleague", .roles = {"administrator"}});
    return centre.session();
  }
  /// Returns a rater's paper sheet: equal marks except the overall one.
  Sheet paper(const AssignmentId& id, std::int64_t overall) {
    return evenSheet(paperForm(office(), id).rubric, overall, 60);
  }
  static std::string refusal(const auto& call) {
    try {
      call();
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }

  UserId colleague_;
  StudyCentre centre;
  std::vector<TraineeId> trainees;
  std::vector<RaterId> chiefs;
  CohortId cohort;
  std::vector<EnrolmentId> enrolled;
};

TEST_F(LiveDay, SheetsOpenForEverybodyWithTheCall) {
  EXPECT_TRUE(linesOf(0).empty());
  EXPECT_EQ(reviewQueue(centre.session()).liveWaiting, 12U);
  const AssignmentId id = sheetOf(0, 1, "pre");
  EXPECT_NE(refusal([&] { (void)openSheet(centre.session(), id); }).find("has not been called"),
            std::string::npos);
  EXPECT_NE(refusal([&] { saveSheet(centre.session(), id, {}, WatchLog()); }).find("has not been called"),
            std::string::npos);

  callTrainee(office(), request(1));

  std::set<std::string> labels;
  for (std::size_t chief = 0; chief < chiefs.size(); ++chief) {
    const std::vector<QueueLine> lines = linesOf(chief);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].shown.assignmentId, sheetOf(chief, 1, "pre"));
    ASSERT_TRUE(lines[0].call.has_value());
    EXPECT_TRUE(lines[0].call->open);
    EXPECT_EQ(lines[0].call->room, kRoom);
    labels.insert(lines[0].shown.label);
    EXPECT_EQ(reviewQueue(centre.asRater(chiefs[chief])).liveCalled, 1U);
    EXPECT_EQ(reviewQueue(centre.session()).liveWaiting, 11U);
  }
  EXPECT_EQ(labels.size(), 1U) << "one label is called out for all";
  EXPECT_EQ(centre.audited("call.begin"), 1);
}

TEST_F(LiveDay, ACallThatIsNotDueNeedsAReason) {
  EXPECT_NE(refusal([&] { callTrainee(office(), request(0, "post")); }).find("has trained 0 of 40 min"),
            std::string::npos);
  train(0, 20);
  EXPECT_NE(refusal([&] { callTrainee(office(), request(0, "pre")); }).find("has trained 20 min already"),
            std::string::npos);
  EXPECT_EQ(checkCall(office(), request(0)).occasion.code, "mid");
  EXPECT_FALSE(checkCall(office(), request(0)).objection);
  ASSERT_EQ(deviations(office(), cohort).size(), 1U);
  EXPECT_EQ(deviations(office(), cohort)[0].description,
            "\"before training\": 0 of 3 sheets were in: training time was logged");
  centre.passTime_us(1);

  callTrainee(office(), request(0, "pre", "was forgotten in the morning"));

  const std::vector<ProtocolDeviation> noted = deviations(office(), cohort);
  ASSERT_EQ(noted.size(), 2U);
  EXPECT_EQ(noted[1].enrolmentId, enrolled[0]);
  EXPECT_NE(noted[1].description.find("has trained 20 min already: was forgotten in the morning"),
            std::string::npos);
}

TEST_F(LiveDay, ARoomHasOneTraineeAndATraineeOneRoom) {
  const LiveCallId first = callTrainee(office(), request(0));
  EXPECT_EQ(callTrainee(office(), request(0)), first) << "called again by another hand";
  EXPECT_NE(refusal([&] { callTrainee(office(), request(1)); })
                .find("T-01 (cohort " + StudyRepository(centre.connection()).cohort(cohort).name +
                      ") is called in this room"),
            std::string::npos);
  EXPECT_NE(
      refusal([&] { callTrainee(office(), request(0, {}, {}, "Room 2")); }).find("called in Skills lab"),
      std::string::npos);
  EXPECT_NE(refusal([&] { callTrainee(office(), request(1, {}, {}, "")); }).find("needs a room"),
            std::string::npos);
  callTrainee(office(), request(1, {}, {}, "Room 2"));
  const LiveCall same{.id = "another station's",
                      .enrolmentId = enrolled[2],
                      .occasionCode = "pre",
                      .room = kRoom,
                      .calledUtc_us = 1};
  EXPECT_THROW(CallRepository(centre.connection()).add(std::span(&same, 1)), DbError) << "at the same moment";
  EXPECT_EQ(linesOf(0).size(), 2U);
  endCall(office(), cohort, first);
  EXPECT_NE(refusal([&] { endCall(office(), cohort, first); }).find("has ended already"), std::string::npos);
  callTrainee(office(), request(2));
}

TEST_F(LiveDay, ListsLateSheetsAndDropsTheCallWhenAllAreIn) {
  const LiveCallId call = callTrainee(office(), request(3));
  score(0, 3, "pre");
  endCall(office(), cohort, call);

  const std::vector<CalledCase> late = calledCases(office(), cohort);
  ASSERT_EQ(late.size(), 1U);
  EXPECT_EQ(late[0].traineeCode, "T-04");
  EXPECT_EQ(late[0].asked, 3U);
  EXPECT_EQ(late[0].submitted, 1U);
  EXPECT_EQ(late[0].missing, (std::vector<std::string>{"R-02", "R-03"}));
  score(1, 3, "pre");  // after the end of the call
  score(2, 3, "pre");
  EXPECT_TRUE(calledCases(office(), cohort).empty());
  EXPECT_NE(refusal([&] { callTrainee(office(), request(3)); }).find("are in"), std::string::npos);
}

TEST_F(LiveDay, ACallOfTheWrongPersonCanBeCancelledUntilSomebodySubmits) {
  const LiveCallId wrong = callTrainee(office(), request(0));
  const AssignmentId id = sheetOf(1, 0, "pre");
  saveSheet(centre.asRater(chiefs[1]), id, {.overall_steps = 50}, WatchLog());
  EXPECT_NE(refusal([&] { cancelCall(office(), cohort, wrong, ""); }).find("needs a reason"),
            std::string::npos);

  cancelCall(office(), cohort, wrong, "T-02 stood there");

  EXPECT_TRUE(calledCases(office(), cohort).empty());
  EXPECT_NE(refusal([&] { (void)openSheet(centre.asRater(chiefs[1]), id); }).find("has not been called"),
            std::string::npos);
  callTrainee(office(), request(0));
  EXPECT_EQ(openSheet(centre.asRater(chiefs[1]), id).sheet.overall_steps, 50) << "what was typed is kept";
  score(0, 0, "pre");
  const CalledCase again = calledCases(office(), cohort).at(0);
  EXPECT_FALSE(again.mayCancel);
  EXPECT_NE(refusal([&] { cancelCall(office(), cohort, again.call.id, "slip"); }).find("submitted already"),
            std::string::npos);
  endCall(office(), cohort, again.call.id);
  centre.passTime_us(1);

  const LiveCallId third = callTrainee(office(), request(0));

  EXPECT_TRUE(calledCases(office(), cohort).at(0).mayCancel) << "the sheet is of the call before";
  EXPECT_NO_THROW(cancelCall(office(), cohort, third, "slip"));
}

TEST_F(LiveDay, FindsAPersonByAScannedCode) {
  EXPECT_EQ(enrolmentWithCode(office(), cohort, " t-03\n"), enrolled[2]);
  EXPECT_THROW((void)enrolmentWithCode(office(), cohort, "T-99"), Error);
  EXPECT_THROW((void)enrolmentWithCode(office(), cohort, ""), Error);
}

TEST_F(LiveDay, CallsAreKeptAndTheTrailVerifies) {
  const LiveCallId call = callTrainee(office(), request(0));
  EXPECT_THROW(centre.connection().execute("UPDATE live_call SET occasion = 'post' WHERE id = ?", {call}),
               DbError);
  setEnrolmentState(office(), cohort, enrolled[1], EnrolmentState::kWithdrawn, "moved away");
  EXPECT_NE(refusal([&] { callTrainee(office(), request(1)); }).find("withdrawn"), std::string::npos);
  EXPECT_TRUE(verifyAuditTrail(centre.connection()).empty());
}

TEST_F(LiveDay, TrainingBeforeTheSheetsAreInIsRefusedOrRecordedWithItsReason) {
  recordConsent(office(), trainees[0], "training_record", true, "1");
  const auto trainee = [&]() -> SessionContext& {
    Actor actor = centre.as("trainee").actor();
    actor.personId = trainees[0];
    centre.session().setActor(actor);
    return centre.session();
  };
  const NextSteps steps = nextSteps(trainee(), trainees[0]);
  ASSERT_TRUE(steps.scoringDue);
  EXPECT_EQ(steps.scoringDue->submitted, 0U);
  EXPECT_EQ(steps.scoringDue->asked, 3U);
  const ManualClock clock;
  DeviceReadiness device;
  device.findings.push_back({"force", Light::kGreen, ""});
  RunRequest wanted{steps.modules.at(0).module.id, false, device};
  EXPECT_NE(refusal([&] { RunSession(trainee(), wanted, clock); }).find("are in: 0 of 3"), std::string::npos);
  EXPECT_TRUE(deviations(office(), cohort).empty());

  wanted.reason = "the arm is out of order";
  {
    RunSession run(trainee(), wanted, clock);
    run.start();
  }

  const std::vector<ProtocolDeviation> noted = deviations(office(), cohort);
  ASSERT_EQ(noted.size(), 1U);
  EXPECT_EQ(noted[0].kind, "trained before scoring");
  EXPECT_EQ(noted[0].description, "\"before training\": 0 of 3 sheets were in: the arm is out of order");
  EXPECT_FALSE(nextSteps(trainee(), trainees[0]).scoringDue) << "asked once";
}

TEST_F(LiveDay, APaperSheetCountsOnceTwoPeopleHaveTypedItAlike) {
  const AssignmentId id = sheetOf(0, 1, "pre");
  EXPECT_NE(refusal([&] { (void)paperForm(office(), id); }).find("has not been called"), std::string::npos);
  callTrainee(office(), request(1));
  ASSERT_EQ(paperCases(office(), cohort).size(), 3U);
  Sheet incomplete = paper(id, 70);
  incomplete.rows.pop_back();
  EXPECT_NE(refusal([&] { enterPaperSheet(office(), id, incomplete); }).find("no mark of the scale"),
            std::string::npos);

  const Sheet right = paper(id, 70);
  EXPECT_EQ(enterPaperSheet(office(), id, right), PaperOutcome::kFirst);
  EXPECT_EQ(enterPaperSheet(office(), id, right), PaperOutcome::kFirst) << "twice by one person is once";
  EXPECT_EQ(linesOf(0).size(), 1U) << "nothing counts so far";

  const Sheet wrong = paper(id, 20);
  EXPECT_EQ(enterPaperSheet(colleague(), id, wrong), PaperOutcome::kDiffers);
  EXPECT_EQ(paperForm(colleague(), id).differing, std::vector<std::string>{kOverallRow});
  EXPECT_TRUE(paperCases(colleague(), cohort).at(0).differs);
  EXPECT_FALSE(SheetRepository(centre.connection()).submitted(id));

  EXPECT_EQ(enterPaperSheet(colleague(), id, right), PaperOutcome::kCounts);

  const auto sealed = SheetRepository(centre.connection()).submitted(id);
  ASSERT_TRUE(sealed);
  EXPECT_EQ(sealed->overall_steps, 70);
  EXPECT_EQ(sealed->rows.size(), right.rows.size());
  EXPECT_EQ(paperCases(office(), cohort).size(), 2U);
  EXPECT_EQ(centre.rowCounts()["paper_entry"], 0);
  EXPECT_EQ(centre.rowCounts()["paper_entry_row"], 0);
  bool told = false;
  for (const AuditEntry& entry :
       auditEntries(office(), {.objectKind = AuditObject::kAssignment, .objectId = id})) {
    told = told || entry.newJson.find(colleague_.text()) != std::string::npos;
  }
  EXPECT_TRUE(told) << "who typed it stands in the audit trail";
  EXPECT_NE(refusal([&] { enterPaperSheet(office(), id, right); }).find("in already"), std::string::npos);
  EXPECT_TRUE(verifyAuditTrail(centre.connection()).empty());
}

TEST_F(LiveDay, PrintedSheetsAreTheDueOnesAndDoNotRevealTheStage) {
  train(2, 20);
  const std::vector<PaperSheet> due = paperSheets(office(), cohort, {}, {});
  ASSERT_EQ(due.size(), 12U);  // four trainees, three raters
  std::set<std::string> labels;
  for (const PaperSheet& sheet : due) {
    labels.insert(sheet.caseLabel);
    EXPECT_FALSE(sheet.rubric.rows.empty());
  }
  EXPECT_EQ(labels.size(), 4U);
  callTrainee(office(), request(2));
  score(0, 2, "mid");
  office();
  EXPECT_EQ(paperSheets(office(), cohort, enrolled[2], {}).size(), 2U);
  EXPECT_EQ(paperSheets(office(), cohort, enrolled[2], "post").size(), 3U);
}

TEST_F(LiveDay, RemindersNameTheMissingCasesOfAssignedRatersOnly) {
  EXPECT_TRUE(reminders(office(), cohort).empty()) << "nobody was called";
  const LiveCallId call = callTrainee(office(), request(3));
  score(1, 3, "pre");
  EXPECT_FALSE(reminders(office(), cohort).at(0).sheets.at(0).late);
  endCall(office(), cohort, call);

  const std::vector<Reminder> owed = reminders(office(), cohort);

  ASSERT_EQ(owed.size(), 2U);
  EXPECT_EQ(owed[0].raterCode, "R-01");
  EXPECT_EQ(owed[0].name, "Chief 1");
  EXPECT_EQ(owed[1].raterCode, "R-03");
  ASSERT_EQ(owed[0].sheets.size(), 1U);
  EXPECT_TRUE(owed[0].sheets[0].late);
  EXPECT_EQ(owed[0].sheets[0].caseLabel, calledCases(office(), cohort).at(0).caseLabel);
}

TEST_F(LiveDay, TheBoardCountsTheSheetsOfEveryOccasionWithACall) {
  train(0, 20);
  const LiveCallId mid = callTrainee(office(), request(0, "mid"));
  score(0, 0, "mid");
  const LiveCallId early =
      callTrainee(office(), request(1, "post", "is away on the last day", "room 2"));  // no training yet
  const LiveCallId wrong = callTrainee(office(), request(2, "post", "is away too", "room 3"));
  cancelCall(office(), cohort, wrong, "somebody else stood there");

  DayBoard board = dayBoard(office(), cohort);
  const auto row = [&](std::size_t trainee) {
    return *std::find_if(board.rows.begin(), board.rows.end(),
                         [&](const DayBoardRow& r) { return r.enrolmentId == enrolled[trainee]; });
  };

  EXPECT_EQ(row(0).allSheetsMissing(), 0U) << "who is at the arm is being scored";
  EXPECT_EQ(row(0).sheetsToCome, 2U);
  EXPECT_EQ(sheetsText(row(0)).str(), "2 to come");
  EXPECT_TRUE(row(1).calledSheets.empty());
  EXPECT_EQ(sheetsText(row(1)).str(), "3, 3 to come");

  endCall(office(), cohort, mid);
  endCall(office(), cohort, early);
  board = dayBoard(office(), cohort);

  EXPECT_EQ(row(0).allSheetsMissing(), 2U) << "of the occasion that is due, once";
  EXPECT_EQ(sheetsText(row(0)).str(), "2");
  EXPECT_TRUE(row(0).calledSheets.empty());
  EXPECT_EQ(row(1).allSheetsMissing() - row(1).sheetsMissing, 3U);
  ASSERT_EQ(row(1).calledSheets.size(), 1U);
  EXPECT_EQ(row(1).calledSheets[0].occasion.code, "post");
  EXPECT_TRUE(row(2).calledSheets.empty()) << "the call was taken back";
  const std::vector<DayAlert> alerts = dayAlerts(board);
  const auto late = std::find_if(alerts.begin(), alerts.end(), [](const DayAlert& alert) {
    return alert.kind == DayAlert::Kind::kSheetsMissing && alert.occasion.code == "post";
  });
  ASSERT_NE(late, alerts.end());
  EXPECT_EQ(late->count, 3U);
}

}  // namespace
}  // namespace torsio
