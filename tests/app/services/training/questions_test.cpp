// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee asks a named chief physician about a moment of a practice run.
#include "app/services/training/questions.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "app/services/training/remarks.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/rubric.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/error.h"
#include "tests/app/support/audit_entries.h"
#include "tests/app/support/training_centre.h"

namespace torsio {
namespace {

using testing::kCentreTime_us;
using testing::kMinute_us;
using testing::TrainingCentre;

ErrorCode refusedWith(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "nothing was refused";
  return ErrorCode::kInternal;
}

class QuestionsTest : public ::testing::Test {
 protected:
  TrainingCentre centre_;
  std::string trial_ = centre_.attempt("first", "practice", 1.0);
  std::string chief_ = PeopleRepository(centre_.connection()).raters().front().person.id;

  SessionContext& desk() { return centre_.session(); }

  void giveToRaters(const TrialId& trialId) {
    SheetRepository sheets(centre_.connection());
    RubricRepository rubrics(centre_.connection());
    rubrics.addRubric("rubric", "Twist sheet", kCentreTime_us, false);
    RubricRevision revision;
    revision.id = "revision";
    revision.rubricId = "rubric";
    revision.overall = {.lo = 10, .hi = 100, .stepsPerPoint = 10};
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
    sheets.assign({&assignment, 1});
  }
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
  EXPECT_EQ(refusedWith([&] { editAnswer(desk(), id, "yes"); }), ErrorCode::kBadParameter);
  answerQuestion(desk(), id, "No, but let go later.");
  centre_.passTime_us(kMinute_us);

  testing::expectAudited(centre_.connection(), desk().actor().userId, "remark.add",
                         [&] { editAnswer(desk(), id, "Yes, and let go later."); });

  const PhysicianQuestion mine = questionsToMe(desk())[0];
  EXPECT_EQ(mine.answer, "Yes, and let go later.");
  EXPECT_EQ(mine.answerEditedUtc_us - mine.answeredUtc_us, kMinute_us);
  ASSERT_EQ(mine.earlierAnswers.size(), 1U);
  EXPECT_EQ(mine.earlierAnswers[0].text, "No, but let go later.");
  EXPECT_EQ(refusedWith([&] { editAnswer(desk(), id, " "); }), ErrorCode::kBadParameter);
  centre_.become("T-01");
  EXPECT_EQ(questionDesk(desk(), trial_).questions[0].answer, "Yes, and let go later.");
  const TraineeRemark thread = ownRemarks(desk())[0].remarks[0];
  EXPECT_EQ(thread.replies[0].earlier.size(), 1U);
  EXPECT_FALSE(thread.replies[0].read);
}

TEST_F(QuestionsTest, NeedATextAndAreBookmarksToo) {
  for (const char* nothing : {"", "  "}) {
    EXPECT_EQ(refusedWith([&] { askPhysician(desk(), trial_, 2.0, chief_, nothing); }),
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
  EXPECT_EQ(refusedWith([&] { askPhysician(desk(), graded, 1.0, chief_, "?"); }), ErrorCode::kPermission);

  giveToRaters(trial_);

  EXPECT_FALSE(questionDesk(desk(), trial_).mayAsk);
  EXPECT_EQ(refusedWith([&] { askPhysician(desk(), trial_, 1.0, chief_, "?"); }), ErrorCode::kPermission);
}

TEST_F(QuestionsTest, AreVisibleToTheTraineeAndToTheChiefWhoWasAsked) {
  const RemarkId id = askPhysician(desk(), trial_, 2.0, chief_, "mine");

  centre_.become("T-02");
  EXPECT_EQ(refusedWith([&] { static_cast<void>(questionDesk(desk(), trial_)); }), ErrorCode::kPermission);
  EXPECT_EQ(refusedWith([&] { askPhysician(desk(), trial_, 2.0, chief_, "yours"); }), ErrorCode::kPermission);
  EXPECT_EQ(refusedWith([&] { answerQuestion(desk(), id, "me too"); }), ErrorCode::kPermission);
  EXPECT_EQ(refusedWith([&] { static_cast<void>(questionsToMe(desk())); }), ErrorCode::kPermission);

  centre_.become("chief");
  EXPECT_EQ(refusedWith([&] { answerQuestion(desk(), id, ""); }), ErrorCode::kBadParameter);
  EXPECT_EQ(refusedWith([&] { answerQuestion(desk(), "none", "so"); }), ErrorCode::kBadParameter);
}

TEST_F(QuestionsTest, NeedAMomentWithinTheRunAndAPhysicianWhoCanBeAsked) {
  for (const double moment : {-1.0, 1e6, std::nan("")}) {
    EXPECT_EQ(refusedWith([&] { askPhysician(desk(), trial_, moment, chief_, "?"); }),
              ErrorCode::kBadParameter);
  }
  EXPECT_EQ(refusedWith([&] { askPhysician(desk(), trial_, 1.0, centre_.person(), "?"); }),
            ErrorCode::kBadParameter);
}

TEST_F(QuestionsTest, AreAudited) {
  std::string id;
  testing::expectAudited(centre_.connection(), desk().actor().userId, "question.ask",
                         [&] { id = askPhysician(desk(), trial_, 2.0, chief_, "seen?"); });
  centre_.become("chief");
  testing::expectAudited(centre_.connection(), desk().actor().userId, "question.answer",
                         [&] { answerQuestion(desk(), id, "seen"); });
}

}  // namespace
}  // namespace torsio
