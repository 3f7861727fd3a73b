// SPDX-License-Identifier: GPL-3.0-or-later
// The outbox for the learning system on both engines: every kind of event, and every state of an entry.

#include <set>
#include <string>

#include "assessment/domain/study/cohort.h"
#include "db/repository/base/learning_events.h"
#include "db/repository/system/setting_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

class LearningRepositoryTest : public SampleTest {
 protected:
  /// Switches sending on and lets a trainee consent.
  static void turnOn(Connection& connection, const PersonId& personId) {
    SettingRepository(connection).set(kLearningSetting, "yes", kSampleTime_us);
    PeopleRepository(connection)
        .recordConsent({.personId = personId,
                        .purpose = kLearningConsent,
                        .granted = true,
                        .textVersion = "1",
                        .decidedUtc_us = kSampleTime_us,
                        .recordedBy = "office"});
  }
  /// Enrols a real trainee in a cohort of their own.
  static Enrolment enrol(Connection& connection, SampleRecord& sample, std::size_t trainee) {
    StudyRepository studies(connection);
    const CohortId cohort = sample.ids.newUuid();
    studies.addCohort({cohort, "Course " + std::to_string(trainee), "", kSampleTime_us, false}, {});
    Enrolment enrolment{.id = sample.ids.newUuid(),
                        .cohortId = cohort,
                        .traineeId = sample.trainees[trainee].person.id,
                        .enrolledUtc_us = kSampleTime_us};
    studies.enrol({&enrolment, 1});
    return enrolment;
  }
};

TEST_F(LearningRepositoryTest, EachKindOfEventIsAddedOnceWithItsData) {
  const PersonId who = sample().trainees[0].person.id;
  turnOn(connection(), who);
  const Enrolment enrolment = enrol(connection(), sample(), 0);
  const Exposure rest{.id = sample().ids.newUuid(),
                      .enrolmentId = enrolment.id,
                      .kind = ExposureKind::kRest,
                      .startedUtc_us = kSampleTime_us,
                      .duration_us = 60'000'000,
                      .recordedBy = "office"};
  StudyRepository(connection()).addExposures({&rest, 1});
  Trial trial = sampleTrial();
  trial.header.traineeCode = sample().trainees[0].person.code;
  trial.header.demonstration = false;
  TrialRepository trials(connection(), {.station = "here", .enrolmentId = enrolment.id});
  trials.begin(trial.header);
  trials.append(trial.chunks.front());
  trials.finish({.samples = trial.chunks.front().samples, .contentHash = "hash"});
  TrialDigest digest;
  digest.trialId = trial.header.trialId;
  digest.formulaVersion = 1;
  digest.tolerance_rad = 0.1;
  for (const std::int64_t version : {1, 2}) {  // a newer formula reports no run again
    digest.formulaVersion = version;
    DigestRepository(connection()).add({&digest, 1});
  }
  const RemarkId remark = sample().ids.newUuid();
  RemarkRepository remarks(connection());
  remarks.add({.id = remark,
               .trialId = trial.header.trialId,
               .author = sample().chiefs[0].person.id.text(),
               .authorPersonId = sample().chiefs[0].person.id,
               .purpose = "remark",
               .text = "gently",
               .createdUtc_us = kSampleTime_us});
  remarks.markRead({.remarkId = remark, .reader = "user", .readerPersonId = who, .readUtc_us = 7});

  LearningRepository outbox(connection());
  const std::vector<LearningEvent> due = outbox.due(kSampleTime_us * 2, 100);

  std::set<LearningEventKind> kinds;
  for (const LearningEvent& event : due) {
    kinds.insert(event.kind);
    EXPECT_EQ(event.personId, who);
    const std::optional<LearningFacts> facts = outbox.facts(event);
    ASSERT_TRUE(facts);
    EXPECT_EQ(facts->enrolmentId, enrolment.id);
    EXPECT_EQ(facts->cohortName, "Course 0");
  }
  EXPECT_EQ(due.size(), 6U);
  EXPECT_EQ(kinds.size(), 6U);
  EXPECT_EQ(due.front().kind, LearningEventKind::kRemarkRead) << "in the order in which things happened";
  EXPECT_TRUE(agreesToLearningRecords(connection(), who));
  EXPECT_FALSE(agreesToLearningRecords(connection(), sample().chiefs[0].person.id));
}

TEST_F(LearningRepositoryTest, AnEntryIsClaimedOnceAndEndsInOneState) {
  SampleRecord sample(connection(), 2);
  for (const Trainee& trainee : sample.trainees) {
    turnOn(connection(), trainee.person.id);
  }
  enrol(connection(), sample, 0);
  enrol(connection(), sample, 1);
  LearningRepository outbox(connection());
  const std::vector<LearningEvent> due = outbox.due(0, 10);
  ASSERT_EQ(due.size(), 2U);
  EXPECT_TRUE(outbox.claim(due[0], 100));
  EXPECT_FALSE(outbox.claim(due[0], 100));
  EXPECT_EQ(outbox.keepStatement(due[0], "{}"), "{}");
  EXPECT_EQ(outbox.keepStatement(due[0], "other"), "{}");
  outbox.setDelivered(due[0], "[\"taken\"]", 5);
  outbox.setRetry(due[1], "[\"busy\"]", 6, 50);
  EXPECT_EQ(outbox.newestError(), "[\"busy\"]");
  EXPECT_TRUE(outbox.due(49, 10).empty());
  EXPECT_EQ(outbox.due(50, 10).size(), 1U);
  outbox.setRefused(due[1], "[\"no\"]", 7);
  EXPECT_EQ(outbox.counts().delivered, 1);
  EXPECT_EQ(outbox.counts().dead, 1);
  EXPECT_EQ(outbox.inState(LearningEventState::kDead, 10).at(0).answer, "[\"no\"]");
  EXPECT_EQ(outbox.retryAll(), 1);
  EXPECT_EQ(outbox.due(0, 10).size(), 1U);
  outbox.setRefused(due[1], "[\"no\"]", 7);
  EXPECT_EQ(outbox.dropRefused(), 1);
  outbox.forget(due[0]);
  EXPECT_EQ(outbox.counts().delivered, 0);
}

}  // namespace
}  // namespace torsio
