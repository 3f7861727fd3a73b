// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/remark.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
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
  Connection connection = openWithSchema();
  Desk desk(connection);
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
  Connection connection = openWithSchema();
  Desk desk(connection);
  const std::string id = desk.ask(0, 1'000'000, kSampleTime_us);

  desk.remark(desk.sample.chiefs[1].person.id, "reply", 1'000'000, "somebody else", id);

  EXPECT_TRUE(desk.questions.find(id)->answerId.empty());
  EXPECT_FALSE(desk.questions.find("none").has_value());
}

TEST_F(QuestionRepositoryTest, AQuestionIsSentOnceAndImmutable) {
  Connection connection = openWithSchema();
  Desk desk(connection);
  const std::string id = desk.ask(0, 1'000'000, kSampleTime_us);

  EXPECT_EQ(
      faultFrom([&] { desk.questions.add({.remarkId = id, .raterId = desk.sample.chiefs[1].person.id}); }),
      DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] { desk.questions.add({.remarkId = "none", .raterId = desk.trainee}); }),
            DbFault::kForeignKey);
  EXPECT_EQ(faultFrom([&] { connection.execute("UPDATE trial_question SET asked_utc_us = 1"); }),
            DbFault::kAppendOnly);
  EXPECT_FALSE(desk.questions.isScored(desk.trialId));
}

}  // namespace
}  // namespace torsio
