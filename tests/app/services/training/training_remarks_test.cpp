// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include <gtest/gtest.h>

#include "app/services/training/debrief.h"
#include "app/services/training/questions.h"
#include "app/services/training/remarks.h"
#include "app/services/training/run_session.h"
#include "app/services/training/transcript.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/remark_repository.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "tests/app/support/audit_entries.h"
#include "tests/app/support/training_centre.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using testing::refusalCode;

/// A trial of T-01 in practice, which a chief physician can be given to score.
class ChiefTest : public ::testing::Test {
 protected:
  TrainingCentre centre_;
  std::string trial_ = centre_.attempt("first", "practice", 1.0);
  std::string chief_ = PeopleRepository(centre_.connection()).raters().front().person.id;

  void giveToRaters(const TrialId& trialId) {
    RubricRepository rubrics(centre_.connection());
    rubrics.addRubric("rubric", "Twist sheet", kCentreTime_us, false);
    RubricRevision revision;
    revision.id = "revision";
    revision.rubricId = "rubric";
    revision.overall = {.lo = 10, .hi = 100, .stepsPerPoint = 10};
    revision.rows.push_back(
        {.code = "proficiency", .label = "Proficiency", .scale = {.lo = 1, .hi = 10, .stepsPerPoint = 1}});
    revision.createdBy = "office";
    rubrics.addRevision(revision);
    const Assignment assignment{.id = "assignment",
                                .raterId = chief_,
                                .enrolmentId = centre_.enrolment(),
                                .occasionCode = "pre",
                                .trialId = trialId,
                                .rubricRevisionId = "revision",
                                .caseLabel = "7F",
                                .assignedBy = "office"};
    SheetRepository(centre_.connection()).assign({&assignment, 1});
  }
};

/// The chief commented on the trial and gave 7 of 10, proficiency 6.
class RemarksTest : public ChiefTest {
 protected:
  std::string remark_ = "11111111-1111-4111-8111-111111111111";

  void SetUp() override {
    giveToRaters(trial_);
    SheetRepository sheets(centre_.connection());
    Sheet sheet;
    sheet.overall_steps = 70;
    sheet.rows.push_back({.code = "proficiency", .score_steps = 6});
    sheets.submit("assignment", "22222222-2222-4222-8222-222222222222", sheet, "", kCentreTime_us);
    RemarkRepository(centre_.connection())
        .add({.id = remark_,
              .trialId = trial_,
              .author = chief_,
              .authorPersonId = chief_,
              .purpose = "remark",
              .tick = 1500,
              .time_us = 1'500'000,
              .text = "let go more gently",
              .createdUtc_us = kCentreTime_us});
  }
  void release() {
    SheetRepository(centre_.connection())
        .setReleased(centre_.cohort().id, "pre", true, "", "office", kCentreTime_us);
  }
};

TEST_F(RemarksTest, AppearWhenTheMarksAreReleased) {
  EXPECT_TRUE(ownRemarks(centre_.session()).empty());
  EXPECT_EQ(unreadRemarks(centre_.session()), 0U);
  EXPECT_THROW(markRemarkRead(centre_.session(), remark_, 1), Error);

  release();

  const std::vector<TrialRemarks> all = ownRemarks(centre_.session());
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].moduleTitle, "Quarter turn, first");
  EXPECT_EQ(all[0].unread, 1U);
  ASSERT_EQ(all[0].remarks.size(), 1U);
  EXPECT_DOUBLE_EQ(all[0].remarks[0].at_s, 1.5);
  EXPECT_EQ(all[0].remarks[0].text, "let go more gently");
  EXPECT_EQ(unreadRemarks(centre_.session()), 1U);
}

TEST_F(RemarksTest, CanBeReadAndAnswered) {
  release();
  markRemarkRead(centre_.session(), remark_, 1);
  replyToRemark(centre_.session(), remark_, "I will");

  const std::vector<TrialRemarks> all = ownRemarks(centre_.session());
  EXPECT_EQ(all[0].unread, 0U);
  ASSERT_EQ(all[0].remarks[0].replies.size(), 1U);
  EXPECT_TRUE(all[0].remarks[0].replies[0].own);
  EXPECT_EQ(all[0].remarks[0].replies[0].text, "I will");
  EXPECT_EQ(unreadRemarks(centre_.session()), 0U);
  EXPECT_THROW(replyToRemark(centre_.session(), remark_, ""), Error);
}

TEST_F(RemarksTest, AnEditShowsTheLatestVersionAndKeepsTheOld) {
  release();
  SessionContext& desk = centre_.session();
  const RemarkId reply = replyToRemark(desk, remark_, "I will");
  centre_.passTime_us(kMinute_us);

  editRemark(desk, reply, "I will try");

  const TraineeRemark own = ownRemarks(desk)[0].remarks[0].replies[0];
  EXPECT_EQ(own.text, "I will try");
  EXPECT_EQ(own.version, 2);
  EXPECT_EQ(own.editedUtc_us - own.writtenUtc_us, kMinute_us);
  ASSERT_EQ(own.earlier.size(), 1U);
  EXPECT_EQ(own.earlier[0].text, "I will");
  EXPECT_EQ(own.earlier[0].writtenUtc_us, own.writtenUtc_us);
  for (const char* words : {"", " ", "I will try"}) {
    EXPECT_THROW(editRemark(desk, reply, words), Error) << words;
  }
  EXPECT_THROW(editRemark(desk, remark_, "not mine"), Error);
  EXPECT_THROW(editRemark(desk, "none", "nothing"), Error);
  EXPECT_EQ(ownRemarks(desk)[0].remarks[0].text, "let go more gently");
}

TEST_F(RemarksTest, ARemarkEditedAfterReadingIsUnreadAgain) {
  release();
  SessionContext& desk = centre_.session();
  markRemarkRead(desk, remark_, 1);
  ASSERT_EQ(unreadRemarks(desk), 0U);

  RemarkRepository(centre_.connection())
      .revise({remark_, 2, chief_, chief_, "let go later", kCentreTime_us + 5});

  EXPECT_EQ(unreadRemarks(desk), 1U);
  EXPECT_FALSE(ownRemarks(desk)[0].remarks[0].read);
  markRemarkRead(desk, remark_, 1);  // the version displayed before
  EXPECT_EQ(unreadRemarks(desk), 1U);
  EXPECT_THROW(markRemarkRead(desk, remark_, 3), Error);
  markRemarkRead(desk, remark_, 2);
  EXPECT_EQ(unreadRemarks(desk), 0U);
}

TEST_F(RemarksTest, AreVisibleToTheTraineeOnly) {
  release();
  centre_.become("T-02");
  EXPECT_TRUE(ownRemarks(centre_.session()).empty());
  EXPECT_THROW(markRemarkRead(centre_.session(), remark_, 1), Error);
  EXPECT_THROW(static_cast<void>(scoreGap(centre_.session(), trial_)), Error);
}

TEST_F(RemarksTest, TheTraineesMarksComeBeforeTheComparison) {
  release();
  const ScoreGap before = scoreGap(centre_.session(), trial_);
  EXPECT_FALSE(before.selfScored);
  EXPECT_TRUE(before.released);
  EXPECT_FALSE(before.overall.panel);  // nothing is shown before the trainee's own marks
  ASSERT_EQ(before.rows.size(), 1U);
  EXPECT_EQ(before.rows[0].label, "Proficiency");
  EXPECT_DOUBLE_EQ(before.overall.highest, 10.0);

  selfScore(centre_.session(), trial_, 8.5, {{"proficiency", 9.0}});

  const ScoreGap gap = scoreGap(centre_.session(), trial_);
  EXPECT_EQ(gap.overall.own, 8.5);
  EXPECT_EQ(gap.overall.panel, 7.0);
  EXPECT_EQ(gap.rows[0].own, 9.0);
  EXPECT_EQ(gap.rows[0].panel, 6.0);
  EXPECT_EQ(gap.raters, 1U);
  EXPECT_THROW(selfScore(centre_.session(), trial_, 7.0, {}), Error);  // the raters' marks were shown
}

TEST_F(RemarksTest, TheTraineesMarksMayChangeUntilTheRatersAreShown) {
  selfScore(centre_.session(), trial_, 8.5, {});
  selfScore(centre_.session(), trial_, 6.0, {{"proficiency", 5.0}});

  const ScoreGap gap = scoreGap(centre_.session(), trial_);
  EXPECT_EQ(gap.overall.own, 6.0);
  EXPECT_FALSE(gap.overall.panel);
  EXPECT_EQ(RemarkRepository(centre_.connection()).selfScores(trial_).size(), 2U);
  EXPECT_THROW(selfScore(centre_.session(), trial_, 10.4, {}), Error);  // outside the scale
  EXPECT_THROW(selfScore(centre_.session(), trial_, 7.03, {}), Error);  // between two steps
  EXPECT_THROW(selfScore(centre_.session(), trial_, 7.0, {{"style", 5.0}}), Error);
}

TEST_F(RemarksTest, EveryChangeAtTheStationIsAuditedAndTheTrailVerifies) {
  SessionContext& desk = centre_.session();
  const auto audited = [&](const char* action, const std::function<void()>& change) {
    expectAudited(centre_.connection(), desk.actor().userId, action, change);
    EXPECT_TRUE(verifyAuditTrail(centre_.connection()).empty()) << action;
  };
  const ManualClock clock;
  RunSession runSession(desk, {centre_.module("first"), false, deviceWith(Light::kGreen)}, clock);

  audited("run.start", [&] { runSession.start(); });
  audited("run.stop", [&] { runSession.stop("enough"); });
  audited("trial.self_score", [&] { selfScore(desk, trial_, 6.0, {}); });
  audited("trial.bookmark", [&] { addBookmark(desk, trial_, 2.5, "good grip"); });
  release();
  audited("remark.read", [&] { markRemarkRead(desk, remark_, 1); });
  RemarkId reply;
  audited("remark.reply", [&] { reply = replyToRemark(desk, remark_, "I will"); });
  audited("remark.add", [&] { editRemark(desk, reply, "I shall"); });
  audited("transcript.make", [&] { (void)transcript(desk, centre_.person()); });
  audited("consent.own", [&] { decideOwnConsent(desk, "training_record", false, "1"); });
}

TEST(Transcript, ContainsEveryAttemptAndTheTimeSpent) {
  TrainingCentre centre;
  for (int i = 0; i < 2; ++i) {
    centre.attempt("first", "practice", 1.0);
  }
  const Exposure hour{.id = "33333333-3333-4333-8333-333333333333",
                      .enrolmentId = centre.enrolment(),
                      .kind = ExposureKind::kReal,
                      .startedUtc_us = kCentreTime_us,
                      .duration_us = 12 * kMinute_us,
                      .recordedBy = "office"};
  StudyRepository(centre.connection()).addExposures({&hour, 1});

  const Transcript sheet = transcript(centre.session(), centre.person());

  EXPECT_EQ(sheet.centre, "Skills laboratory");
  EXPECT_EQ(sheet.traineeCode, "T-01");
  ASSERT_EQ(sheet.modules.size(), 3U);
  EXPECT_EQ(sheet.modules[0].attempts.size(), 2U);
  EXPECT_EQ(sheet.modules[0].step.state, StepState::kMastered);
  EXPECT_DOUBLE_EQ(sheet.real_min, 12.0);
}

// A trainee asks a named chief physician about a moment of a practice run.

class QuestionsTest : public ChiefTest {
 protected:
  SessionContext& desk() { return centre_.session(); }
};

TEST_F(QuestionsTest, GoToTheChiefAndTheAnswerAppearsAtTheMoment) {
  PeopleRepository(centre_.connection()).setIdentity({.personId = chief_, .fullName = "Dr. Li Na"});
  PeopleRepository(centre_.connection()).setIdentity({.personId = centre_.person(), .fullName = "Chen Wei"});
  const QuestionDesk before = questionDesk(desk(), trial_);
  ASSERT_TRUE(before.mayAsk);
  ASSERT_EQ(before.physicians.size(), 1U);
  EXPECT_EQ(before.physicians[0].name, "Dr. Li Na");
  EXPECT_FALSE(before.physicians[0].lastAsked);

  const RemarkId id = askPhysician(desk(), trial_, 3.5, chief_, "too fast?");
  centre_.passTime_us(90 * kMinute_us);

  centre_.become("chief");
  const std::vector<PhysicianQuestion> waiting = questionsToMe(desk());
  ASSERT_EQ(waiting.size(), 1U);
  EXPECT_EQ(waiting[0].trainee, "Chen Wei");
  EXPECT_EQ(waiting[0].moduleTitle, "Quarter turn, first");
  EXPECT_DOUBLE_EQ(waiting[0].at_s, 3.5);
  EXPECT_EQ(waiting[0].text, "too fast?");
  EXPECT_FALSE(waiting[0].answered);
  EXPECT_EQ(desk().now_us() - waiting[0].askedUtc_us, 90 * kMinute_us);
  const Debrief run = questionedRun(desk(), id);
  EXPECT_FALSE(run.own.empty());
  ASSERT_EQ(run.bookmarks.size(), 1U);
  EXPECT_DOUBLE_EQ(run.bookmarks[0].at_s, 3.5);
  answerQuestion(desk(), id, "No, but let go later.");
  EXPECT_TRUE(questionsToMe(desk())[0].answered);

  centre_.become("T-01");
  const QuestionDesk after = questionDesk(desk(), trial_);
  ASSERT_EQ(after.questions.size(), 1U);
  EXPECT_TRUE(after.questions[0].answered);
  EXPECT_EQ(after.questions[0].physician, "Dr. Li Na");
  EXPECT_EQ(after.questions[0].answer, "No, but let go later.");
  EXPECT_TRUE(after.physicians[0].lastAsked);
  EXPECT_EQ(unreadRemarks(desk()), 1U);
  const std::vector<TrialRemarks> remarks = ownRemarks(desk());
  ASSERT_EQ(remarks.size(), 1U);
  ASSERT_EQ(remarks[0].remarks.size(), 1U);
  EXPECT_TRUE(remarks[0].remarks[0].question);
  ASSERT_EQ(remarks[0].remarks[0].replies.size(), 1U);
  EXPECT_EQ(remarks[0].remarks[0].replies[0].text, "No, but let go later.");
}

TEST_F(QuestionsTest, AnAnswerCanBeEditedByItsAuthor) {
  const RemarkId id = askPhysician(desk(), trial_, 3.5, chief_, "too fast?");
  centre_.become("chief");
  EXPECT_EQ(refusalCode([&] { editAnswer(desk(), id, "yes"); }), ErrorCode::kBadParameter);
  answerQuestion(desk(), id, "No, but let go later.");
  centre_.passTime_us(kMinute_us);

  expectAudited(centre_.connection(), desk().actor().userId, "remark.add",
                [&] { editAnswer(desk(), id, "Yes, and let go later."); });

  const PhysicianQuestion mine = questionsToMe(desk())[0];
  EXPECT_EQ(mine.answer, "Yes, and let go later.");
  EXPECT_EQ(mine.answerEditedUtc_us - mine.answeredUtc_us, kMinute_us);
  ASSERT_EQ(mine.earlierAnswers.size(), 1U);
  EXPECT_EQ(mine.earlierAnswers[0].text, "No, but let go later.");
  EXPECT_EQ(refusalCode([&] { editAnswer(desk(), id, " "); }), ErrorCode::kBadParameter);
  centre_.become("T-01");
  EXPECT_EQ(questionDesk(desk(), trial_).questions[0].answer, "Yes, and let go later.");
  const TraineeRemark thread = ownRemarks(desk())[0].remarks[0];
  EXPECT_EQ(thread.replies[0].earlier.size(), 1U);
  EXPECT_FALSE(thread.replies[0].read);
}

TEST_F(QuestionsTest, NeedATextAndAreBookmarksToo) {
  for (const char* nothing : {"", "  "}) {
    EXPECT_EQ(refusalCode([&] { askPhysician(desk(), trial_, 2.0, chief_, nothing); }),
              ErrorCode::kBadParameter);
  }
  EXPECT_TRUE(questionDesk(desk(), trial_).questions.empty());
  const RemarkId id = askPhysician(desk(), trial_, 2.0, chief_, "too fast?");

  const QuestionDesk now = questionDesk(desk(), trial_);
  ASSERT_EQ(now.questions.size(), 1U);
  EXPECT_EQ(now.questions[0].id, id);
  EXPECT_EQ(now.questions[0].text, "too fast?");
  EXPECT_TRUE(ownRemarks(desk()).empty());  // nothing to read before the answer
}

TEST_F(QuestionsTest, AreRefusedForARunThatIsJudgedAnonymously) {
  const std::string graded = centre_.attempt("second", "graded", 1.0);
  EXPECT_FALSE(questionDesk(desk(), graded).mayAsk);
  EXPECT_EQ(refusalCode([&] { askPhysician(desk(), graded, 1.0, chief_, "?"); }), ErrorCode::kPermission);

  giveToRaters(trial_);

  EXPECT_FALSE(questionDesk(desk(), trial_).mayAsk);
  EXPECT_EQ(refusalCode([&] { askPhysician(desk(), trial_, 1.0, chief_, "?"); }), ErrorCode::kPermission);
}

TEST_F(QuestionsTest, AreVisibleToTheTraineeAndToTheChiefWhoWasAsked) {
  const RemarkId id = askPhysician(desk(), trial_, 2.0, chief_, "mine");

  centre_.become("T-02");
  EXPECT_EQ(refusalCode([&] { static_cast<void>(questionDesk(desk(), trial_)); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { askPhysician(desk(), trial_, 2.0, chief_, "yours"); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { answerQuestion(desk(), id, "me too"); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(questionsToMe(desk())); }), ErrorCode::kPermission);

  centre_.become("chief");
  EXPECT_EQ(refusalCode([&] { answerQuestion(desk(), id, ""); }), ErrorCode::kBadParameter);
  EXPECT_EQ(refusalCode([&] { answerQuestion(desk(), "none", "so"); }), ErrorCode::kBadParameter);
}

TEST_F(QuestionsTest, NeedAMomentWithinTheRunAndAPhysicianWhoCanBeAsked) {
  for (const double moment : {-1.0, 1e6, std::nan("")}) {
    EXPECT_EQ(refusalCode([&] { askPhysician(desk(), trial_, moment, chief_, "?"); }),
              ErrorCode::kBadParameter);
  }
  EXPECT_EQ(refusalCode([&] { askPhysician(desk(), trial_, 1.0, centre_.person(), "?"); }),
            ErrorCode::kBadParameter);
}

TEST_F(QuestionsTest, AreAudited) {
  std::string id;
  expectAudited(centre_.connection(), desk().actor().userId, "question.ask",
                [&] { id = askPhysician(desk(), trial_, 2.0, chief_, "seen?"); });
  centre_.become("chief");
  expectAudited(centre_.connection(), desk().actor().userId, "question.answer",
                [&] { answerQuestion(desk(), id, "seen"); });
}

}  // namespace
}  // namespace torsio
