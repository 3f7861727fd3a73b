// SPDX-License-Identifier: GPL-3.0-or-later

#include "db/repository/trial/remark_repository.h"

#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/remark.h"
#include "assessment/domain/rating/rubric.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {

namespace {

class RemarkRepositoryTest : public DatabaseTest {
 protected:
  /// One trainee with one trial, one chief.
  struct Desk {
    explicit Desk(Connection& connection) : sample(connection, 1), remarks(connection) {
      trialId = sample.ids.newUuid();
      trainee = sample.trainees[0].person.id;
      chief = sample.chiefs[0].person.id;
      TrialRepository(connection).begin(sampleHeader(trialId, "T-01"));
    }
    Remark remark(const std::string& author, const std::string& purpose, std::int64_t time_us,
                  const std::string& text, const std::string& replyTo = "") {
      return {.id = sample.ids.newUuid(),
              .trialId = trialId,
              .author = author,
              .authorPersonId = author,
              .purpose = purpose,
              .replyTo = replyTo,
              .tick = time_us / 1000,
              .time_us = time_us,
              .text = text,
              .createdUtc_us = kSampleTime_us + ++written,
              .demonstration = true};
    }
    SampleRecord sample;
    RemarkRepository remarks;
    TrialId trialId;
    std::string trainee;
    std::string chief;
    std::int64_t written = 0;
  };
};

TEST_F(RemarkRepositoryTest, ReturnsRemarksByTheirTimeInTheTrial) {
  Desk desk(connection());
  const Remark late = desk.remark(desk.chief, "remark", 9'000'000, "too fast here");
  const Remark early = desk.remark(desk.trainee, "bookmark", 2'000'000, "");
  desk.remarks.add(late);
  desk.remarks.add(early);

  const std::vector<Remark> found = desk.remarks.remarks(desk.trialId);

  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].id, early.id);
  EXPECT_EQ(found[0].purpose, "bookmark");
  EXPECT_EQ(found[1].text, "too fast here");
  EXPECT_EQ(found[1].author, desk.chief);
  EXPECT_EQ(found[1].authorPersonId, desk.chief);
  EXPECT_EQ(found[1].tick, 9000);
  EXPECT_EQ(found[1].time_us, 9'000'000);
  EXPECT_EQ(found[1].createdUtc_us, kSampleTime_us + 1);
  EXPECT_TRUE(found[1].demonstration);
  EXPECT_EQ(desk.remarks.find(late.id)->text, "too fast here");
  EXPECT_FALSE(desk.remarks.find("none").has_value());
}

TEST_F(RemarkRepositoryTest, ARemarkIsUnreadUntilFirstRead) {
  Desk desk(connection());
  const Remark remark = desk.remark(desk.chief, "remark", 1, "look");
  desk.remarks.add(remark);
  desk.remarks.add(desk.remark(desk.trainee, "bookmark", 2, "mine"));
  ASSERT_EQ(desk.remarks.unreadOnTrialsOf(desk.trainee, desk.trainee).size(), 1U);
  EXPECT_TRUE(
      desk.remarks.unreadOnTrialsOf(desk.trainee, desk.chief).empty());  // one's own remarks are never unread

  desk.remarks.markRead({remark.id, 1, desk.trainee, desk.trainee, kSampleTime_us + 10});
  desk.remarks.markRead({remark.id, 1, desk.trainee, desk.trainee, kSampleTime_us + 20});

  EXPECT_TRUE(desk.remarks.unreadOnTrialsOf(desk.trainee, desk.trainee).empty());
  const std::vector<ReadReceipt> receipts = desk.remarks.receipts(desk.trialId);
  ASSERT_EQ(receipts.size(), 1U);
  EXPECT_EQ(receipts[0].remarkId, remark.id);
  EXPECT_EQ(receipts[0].readUtc_us, kSampleTime_us + 10);
}

TEST_F(RemarkRepositoryTest, AReplyReachesTheAuthorOfTheRemark) {
  Desk desk(connection());
  const Remark remark = desk.remark(desk.chief, "remark", 1, "why so fast?");
  desk.remarks.add(remark);
  const Remark reply = desk.remark(desk.trainee, "reply", 1, "it slipped", remark.id);

  desk.remarks.add(reply);

  const std::vector<Remark> unread = desk.remarks.unreadReplies(desk.chief);
  ASSERT_EQ(unread.size(), 1U);
  EXPECT_EQ(unread[0].replyTo, remark.id);
  desk.remarks.markRead({reply.id, 1, desk.chief, desk.chief, kSampleTime_us});
  EXPECT_TRUE(desk.remarks.unreadReplies(desk.chief).empty());
  EXPECT_EQ(faultFrom([&] { desk.remarks.add(desk.remark(desk.chief, "reply", 1, "to nothing")); }),
            DbFault::kCheck);
  EXPECT_EQ(faultFrom([&] { desk.remarks.add(desk.remark(desk.chief, "reply", 1, "lost", "none")); }),
            DbFault::kForeignKey);
}

TEST_F(RemarkRepositoryTest, RemarksAreStoredOnceAndImmutable) {
  Desk desk(connection());
  Remark remark = desk.remark(desk.chief, "remark", 1, "look");
  desk.remarks.add(remark);
  desk.remarks.add(remark);
  desk.remarks.markRead({remark.id, 1, desk.trainee, desk.trainee, kSampleTime_us});
  remark.text = "look away";

  EXPECT_EQ(faultFrom([&] { desk.remarks.add(remark); }), DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE trial_remark SET text = ?", {"x"}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM remark_receipt"); }), DbFault::kAppendOnly);
  EXPECT_EQ(desk.remarks.remarks(desk.trialId).size(), 1U);
}

TEST_F(RemarkRepositoryTest, AnEditKeepsTheOldTextAndIsUnreadAgain) {
  Desk desk(connection());
  const Remark remark = desk.remark(desk.chief, "remark", 1, "look");
  desk.remarks.add(remark);
  desk.remarks.add(desk.remark(desk.chief, "remark", 2, "never edited"));
  desk.remarks.markRead({remark.id, 1, desk.trainee, desk.trainee, kSampleTime_us});
  ASSERT_EQ(desk.remarks.unreadOnTrialsOf(desk.trainee, desk.trainee).size(), 1U);
  const RemarkRevision second{remark.id, 2, desk.chief, desk.chief, "look closely", kSampleTime_us + 50};
  const RemarkRevision third{remark.id, 3, desk.chief, desk.chief, "look here", kSampleTime_us + 90};

  desk.remarks.revise(second);
  desk.remarks.revise(second);
  desk.remarks.revise(third);

  const Remark now = *desk.remarks.find(remark.id);
  EXPECT_EQ(now.text, "look here");
  EXPECT_EQ(now.version, 3);
  EXPECT_EQ(now.editedUtc_us, kSampleTime_us + 90);
  EXPECT_EQ(now.createdUtc_us, remark.createdUtc_us);
  const auto earlier = desk.remarks.earlierWordings(desk.trialId);
  ASSERT_EQ(earlier.size(), 1U);
  ASSERT_EQ(earlier.at(remark.id).size(), 2U);
  EXPECT_EQ(earlier.at(remark.id)[0].text, "look");
  EXPECT_EQ(earlier.at(remark.id)[1].text, "look closely");
  EXPECT_EQ(earlier.at(remark.id)[1].writtenUtc_us, kSampleTime_us + 50);
  EXPECT_EQ(desk.remarks.unreadOnTrialsOf(desk.trainee, desk.trainee).size(), 2U);
  desk.remarks.markRead({remark.id, 3, desk.trainee, desk.trainee, kSampleTime_us});
  EXPECT_EQ(desk.remarks.unreadOnTrialsOf(desk.trainee, desk.trainee).size(), 1U);
  EXPECT_EQ(faultFrom([&] {
              desk.remarks.revise({remark.id, 3, desk.chief, desk.chief, "other"});
            }),
            DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] {
              desk.remarks.revise({"none", 2, desk.chief, desk.chief, "x"});
            }),
            DbFault::kForeignKey);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE remark_revision SET text = ?", {"x"}); }),
            DbFault::kAppendOnly);
}

TEST_F(RemarkRepositoryTest, KeepsEveryVersionOfASelfScoreWithItsRows) {
  Desk desk(connection());
  RubricRepository rubrics(connection());
  rubrics.addRubric("rubric", "Twist", kSampleTime_us, true);
  RubricRevision revision{.id = "revision", .rubricId = "rubric"};
  revision.overall = {10, 100, 10};
  revision.rows = {{"time", "time", {10, 100, 10}, {}}, {"force", "force", {10, 100, 10}, {}}};
  rubrics.addRevision(revision);
  SelfScore first{.id = desk.sample.ids.newUuid(), .trialId = desk.trialId, .traineeId = desk.trainee};
  first.rubricRevisionId = "revision";
  first.score_steps = 70;
  first.rows = {{"revision", "time", 60}, {"revision", "force", 80}};
  first.createdUtc_us = kSampleTime_us;
  SelfScore second = first;
  second.id = desk.sample.ids.newUuid();
  second.version = 2;
  second.score_steps = 55;
  second.rows = {};

  desk.remarks.addSelfScore(first);
  desk.remarks.addSelfScore(first);
  desk.remarks.addSelfScore(second);

  const std::vector<SelfScore> scores = desk.remarks.selfScores(desk.trialId);
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[0].score_steps, 70);
  EXPECT_EQ(scores[0].scale.hi, 100);
  ASSERT_EQ(scores[0].rows.size(), 2U);
  EXPECT_EQ(scores[0].rows[0].rowCode, "force");
  EXPECT_EQ(scores[0].rows[0].score_steps, 80);
  EXPECT_EQ(scores[1].score_steps, 55);
  EXPECT_TRUE(scores[1].rows.empty());
  first.rows[0].score_steps = 61;
  EXPECT_EQ(faultFrom([&] { desk.remarks.addSelfScore(first); }), DbFault::kUnique);
  second.id = "other";
  EXPECT_EQ(faultFrom([&] { desk.remarks.addSelfScore(second); }), DbFault::kUnique);
}

TEST_F(RemarkRepositoryTest, KeepsTheCalibrationScoresOfARater) {
  Desk desk(connection());
  CalibrationScore score{
      .id = desk.sample.ids.newUuid(), .raterId = desk.chief, .referenceTrialId = desk.trialId};
  score.score_steps = 80;
  score.panelOffset_steps = 80.0 - 71.5;
  score.createdUtc_us = kSampleTime_us;
  desk.remarks.addCalibrationScore(score);

  const std::vector<CalibrationScore> found = desk.remarks.calibrationScores(desk.chief);

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].referenceTrialId, desk.trialId);
  EXPECT_EQ(found[0].panelOffset_steps, 8.5);
  EXPECT_TRUE(desk.remarks.calibrationScores(desk.trainee).empty());
}

}  // namespace

namespace {

class QuestionRepositoryTest : public DatabaseTest {
 protected:
  /// One trainee with one trial, two chiefs.
  struct Desk {
    explicit Desk(Connection& connection)
        : sample(connection, 1), remarks(connection), questions(connection) {
      trialId = sample.ids.newUuid();
      trainee = sample.trainees[0].person.id;
      TrialRepository(connection).begin(sampleHeader(trialId, "T-01"));
    }
    /// Asks chief number `chief`.
    std::string ask(std::size_t chief, std::int64_t time_us, std::int64_t askedUtc_us) {
      const std::string id = remark(trainee, "bookmark", time_us, "why?", "");
      questions.add({.remarkId = id, .raterId = sample.chiefs[chief].person.id, .askedUtc_us = askedUtc_us});
      return id;
    }
    std::string remark(const std::string& author, const std::string& purpose, std::int64_t time_us,
                       const std::string& text, const std::string& replyTo) {
      const std::string id = sample.ids.newUuid();
      remarks.add({.id = id,
                   .trialId = trialId,
                   .author = author,
                   .authorPersonId = author,
                   .purpose = purpose,
                   .replyTo = replyTo,
                   .tick = time_us / 1000,
                   .time_us = time_us,
                   .text = text,
                   .createdUtc_us = kSampleTime_us + 500,
                   .demonstration = true});
      return id;
    }
    SampleRecord sample;
    RemarkRepository remarks;
    QuestionRepository questions;
    TrialId trialId;
    std::string trainee;
  };
};

TEST_F(QuestionRepositoryTest, UnansweredQuestionsComeFirstOldestFirst) {
  Desk desk(connection());
  const std::string chief = desk.sample.chiefs[0].person.id;
  const std::string answered = desk.ask(0, 3'000'000, kSampleTime_us);
  const std::string young = desk.ask(0, 1'000'000, kSampleTime_us + 200);
  const std::string old = desk.ask(0, 2'000'000, kSampleTime_us + 100);
  desk.ask(1, 4'000'000, kSampleTime_us + 300);
  desk.remark(chief, "reply", 3'000'000, "so", answered);

  const std::vector<TraineeQuestion> found = desk.questions.toRater(chief);

  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].remarkId, old);
  EXPECT_EQ(found[1].remarkId, young);
  EXPECT_EQ(found[2].remarkId, answered);
  EXPECT_EQ(found[2].answerText, "so");
  EXPECT_EQ(found[2].answeredUtc_us, kSampleTime_us + 500);
  EXPECT_EQ(found[0].personId, desk.trainee);
  EXPECT_EQ(found[0].time_us, 2'000'000);
  EXPECT_EQ(found[0].text, "why?");
  EXPECT_TRUE(found[0].answerId.empty());
  EXPECT_EQ(desk.questions.ofTrial(desk.trialId).size(), 4U);
  EXPECT_EQ(desk.questions.lastAsked(desk.trainee), desk.sample.chiefs[1].person.id);
  EXPECT_EQ(desk.questions.lastAsked(chief), "");
}

TEST_F(QuestionRepositoryTest, OnlyTheAskedRatersReplyIsTheAnswer) {
  Desk desk(connection());
  const std::string id = desk.ask(0, 1'000'000, kSampleTime_us);

  desk.remark(desk.sample.chiefs[1].person.id, "reply", 1'000'000, "somebody else", id);

  EXPECT_TRUE(desk.questions.find(id)->answerId.empty());
  EXPECT_FALSE(desk.questions.find("none").has_value());
}

TEST_F(QuestionRepositoryTest, AQuestionIsSentOnceAndImmutable) {
  Desk desk(connection());
  const std::string id = desk.ask(0, 1'000'000, kSampleTime_us);

  EXPECT_EQ(
      faultFrom([&] { desk.questions.add({.remarkId = id, .raterId = desk.sample.chiefs[1].person.id}); }),
      DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] { desk.questions.add({.remarkId = "none", .raterId = desk.trainee}); }),
            DbFault::kForeignKey);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE trial_question SET asked_utc_us = 1"); }),
            DbFault::kAppendOnly);
  EXPECT_FALSE(desk.questions.isScored(desk.trialId));
}

}  // namespace

}  // namespace torsio
