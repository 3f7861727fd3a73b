// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/retention_repository.h"

#include "assessment/domain/people/person.h"
#include "assessment/domain/people/retention.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

class RetentionRepositoryTest : public DatabaseTest {
 protected:
  /// A real trainee "R-<n>", added on the sample day.
  static PersonId addTrainee(Connection& connection, const std::string& code,
                             PersonState state = PersonState::kActive) {
    Trainee trainee;
    trainee.person = {.id = "id of " + code, .code = code, .state = state, .createdUtc_us = kSampleTime_us};
    PeopleRepository(connection).addTrainees(std::span(&trainee, 1));
    return trainee.person.id;
  }
};

TEST_F(RetentionRepositoryTest, NobodyIsDueWithoutARuleOrBeforeTheTime) {
  Connection connection = openWithSchema();
  RetentionRepository retention(connection);
  addTrainee(connection, "R-1");
  EXPECT_TRUE(retention.due(INT64_MAX / 2).empty());
  retention.setRule({kRetainTrainee, 30, "contract", 1});

  EXPECT_TRUE(retention.due(kSampleTime_us + 30 * kDay_us - 1).empty());
  const std::vector<RetentionItem> due = retention.due(kSampleTime_us + 30 * kDay_us);

  ASSERT_EQ(due.size(), 1U);
  EXPECT_EQ(due[0].code, "R-1");
  EXPECT_EQ(due[0].category, "trainee");
  EXPECT_EQ(due[0].basis, "contract");
  EXPECT_EQ(due[0].sinceUtc_us, kSampleTime_us);
  EXPECT_EQ(due[0].dueUtc_us, kSampleTime_us + 30 * kDay_us);
  EXPECT_FALSE(due[0].held);
}

TEST_F(RetentionRepositoryTest, ThePeriodStartsAtTheLastActivity) {
  Connection connection = openWithSchema();
  RetentionRepository retention(connection);
  retention.setRule({kRetainTrainee, 30, "contract", 1});
  addTrainee(connection, "R-1");
  addTrainee(connection, "R-2");
  TrialHeader header = sampleHeader("trial", "R-1");
  header.startedUtc_us = kSampleTime_us + 10 * kDay_us;
  header.demonstration = false;
  TrialRepository(connection).begin(header);

  EXPECT_EQ(retention.due(kSampleTime_us + 39 * kDay_us).size(), 1U);
  const std::vector<RetentionItem> due = retention.due(kSampleTime_us + 40 * kDay_us);

  ASSERT_EQ(due.size(), 2U);
  EXPECT_EQ(due[0].code, "R-2");  // longest overdue first
  EXPECT_EQ(due[1].sinceUtc_us, kSampleTime_us + 10 * kDay_us);
}

TEST_F(RetentionRepositoryTest, AMarkOfAnyEnrolmentIsAnActivity) {
  Connection connection = openWithSchema();
  SampleRecord sample(connection, 0);
  RetentionRepository retention(connection);
  retention.setRule({kRetainTrainee, 30, "contract", 1});
  addTrainee(connection, "R-1");
  addTrainee(connection, "R-2");
  const Enrolment enrolment{.id = "enrolment",
                            .cohortId = sample.cohort.id,
                            .traineeId = "id of R-1",
                            .enrolledUtc_us = kSampleTime_us};
  StudyRepository(connection).enrol(std::span(&enrolment, 1));
  std::vector<SubmittedMark> marks;
  for (const auto& [point, day] : {std::pair("pre", 5), std::pair("post", 20), std::pair("mid", 10)}) {
    SubmittedMark mark;
    mark.id = sample.ids.newUuid();
    mark.enrolmentId = enrolment.id;
    mark.raterId = sample.chiefs[0].person.id;
    mark.occasionCode = point;
    mark.score_steps = 40;
    mark.submittedUtc_us = kSampleTime_us + day * kDay_us;
    marks.push_back(mark);
  }
  RatingRepository(connection).submit(marks);

  const std::vector<RetentionItem> due = retention.due(kSampleTime_us + 50 * kDay_us);

  ASSERT_EQ(due.size(), 2U);
  EXPECT_EQ(due[0].code, "R-2");
  EXPECT_EQ(due[0].sinceUtc_us, kSampleTime_us);
  EXPECT_EQ(due[1].code, "R-1");
  EXPECT_EQ(due[1].sinceUtc_us, kSampleTime_us + 20 * kDay_us);
}

TEST_F(RetentionRepositoryTest, PeopleWhoLeftOrWithdrewAreDueByTheEarliestRule) {
  Connection connection = openWithSchema();
  RetentionRepository retention(connection);
  retention.setRule({kRetainTrainee, 400, "contract", 1});
  retention.setRule({kRetainLeft, 100, "contract", 1});
  retention.setRule({kRetainWithdrawn, 7, "consent", 1});
  addTrainee(connection, "R-1", PersonState::kLeft);
  const std::string withdrew = addTrainee(connection, "R-2");
  const std::string again = addTrainee(connection, "R-3");
  PeopleRepository people(connection);
  people.recordConsent({withdrew, "training_record", false, "1", kSampleTime_us + kDay_us, "admin", false});
  people.recordConsent({again, "training_record", false, "1", kSampleTime_us, "admin", false});
  people.recordConsent({again, "training_record", true, "1", kSampleTime_us + kDay_us, "admin", false});

  const std::vector<RetentionItem> due = retention.due(kSampleTime_us + 100 * kDay_us);

  ASSERT_EQ(due.size(), 2U);
  EXPECT_EQ(due[0].code, "R-2");
  EXPECT_EQ(due[0].category, "consent_withdrawn");
  EXPECT_EQ(due[0].sinceUtc_us, kSampleTime_us + kDay_us);
  EXPECT_EQ(due[1].code, "R-1");
  EXPECT_EQ(due[1].category, "left");
}

TEST_F(RetentionRepositoryTest, AReviewerLocksExtendsAndReleases) {
  Connection connection = openWithSchema();
  RetentionRepository retention(connection);
  retention.setRule({kRetainTrainee, 30, "contract", 1});
  const std::string id = addTrainee(connection, "R-1");
  const std::int64_t now_us = kSampleTime_us + 50 * kDay_us;
  const auto held = [&](std::int64_t at_us) { return retention.due(at_us).at(0).held; };

  retention.addHold({id, HoldKind::kExtend, now_us + 10 * kDay_us, "thesis", "admin", now_us});
  EXPECT_TRUE(held(now_us));
  EXPECT_FALSE(held(now_us + 10 * kDay_us));
  retention.addHold({id, HoldKind::kLock, {}, "appeal", "admin", now_us});
  EXPECT_TRUE(held(now_us + 1000 * kDay_us));
  EXPECT_EQ(retention.due(now_us).at(0).hold->reason, "appeal");
  retention.addHold({id, HoldKind::kRelease, {}, "appeal decided", "admin", now_us});
  EXPECT_FALSE(held(now_us));

  EXPECT_EQ(numberFrom(connection, "SELECT count(*) FROM retention_hold"), 3);
  EXPECT_EQ(faultFrom([&] {
              retention.addHold({id, HoldKind::kExtend, {}, "", "admin", 1});
            }),
            DbFault::kCheck);
  EXPECT_EQ(faultFrom([&] {
              retention.addHold({id, HoldKind::kExtend, {}, "", "admin", 1});
            }),
            DbFault::kCheck);
  EXPECT_EQ(faultFrom([&] {
              retention.addHold({"none", HoldKind::kLock, {}, "", "admin", 1});
            }),
            DbFault::kForeignKey);
  EXPECT_EQ(faultFrom([&] { connection.execute("DELETE FROM retention_hold"); }), DbFault::kAppendOnly);
}

TEST_F(RetentionRepositoryTest, SimulatedAndErasedPeopleAreNeverDue) {
  Connection connection = openWithSchema();
  const SampleRecord simulated(connection, 1);
  RetentionRepository retention(connection);
  retention.setRule({kRetainTrainee, 1, "contract", 1});
  retention.setRule({kRetainRater, 1, "contract", 1});
  erasePerson(connection, addTrainee(connection, "R-1"), "admin", "asked", kSampleTime_us);

  EXPECT_TRUE(retention.due(kSampleTime_us + 1000 * kDay_us).empty());
}

TEST_F(RetentionRepositoryTest, RulesAreReplacedAndValidated) {
  Connection connection = openWithSchema();
  RetentionRepository retention(connection);
  retention.setRule({kRetainLeft, 30, "contract", 1});
  retention.setRule({kRetainLeft, 60, "law", 2});
  ASSERT_EQ(retention.rules().size(), 1U);
  EXPECT_EQ(retention.rules()[0].keep_days, 60);
  for (const RetentionRule& bad :
       {RetentionRule{"everything", 30, "", 1}, RetentionRule{kRetainLeft, 0, "", 1},
        RetentionRule{kRetainLeft, 40'000, "", 1}}) {
    EXPECT_EQ(refusalFrom([&] { retention.setRule(bad); }).code, ErrorCode::kBadParameter);
  }
  retention.removeRule(kRetainLeft);
  EXPECT_TRUE(retention.rules().empty());
}

}  // namespace
}  // namespace torsio
