// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/freeze_repository.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

class DiscrepancyRepositoryTest : public DatabaseTest {
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
  Connection connection = openWithSchema();
  SampleRecord sample(connection, 1);
  const std::string id = assignmentIn(connection, sample);
  DiscrepancyRepository decisions(connection, "room 1");

  EXPECT_FALSE(decisions.latest(id).has_value());
  EXPECT_EQ(decisions.add({id, 0, DiscrepancyChoice::kThird, "far apart", "admin", kSampleTime_us}), 1);
  EXPECT_EQ(decisions.add({id, 0, DiscrepancyChoice::kKeep, "looked again", "chief", kSampleTime_us + 1}), 2);

  ASSERT_EQ(decisions.history(id).size(), 2U);
  EXPECT_EQ(decisions.history(id)[0].reason, "far apart");
  EXPECT_EQ(decisions.latest(id)->choice, DiscrepancyChoice::kKeep);
  ASSERT_EQ(decisions.ofCohort(sample.cohort.id).size(), 1U);
  EXPECT_EQ(decisions.ofCohort(sample.cohort.id)[0].sequence, 2);
  EXPECT_TRUE(decisions.ofCohort("another").empty());
  const AuditEntry entry = AuditRepository(connection).entries().at(0);
  EXPECT_EQ(entry.action, "alignment.keep");
  EXPECT_EQ(entry.station, "room 1");
  EXPECT_EQ(faultFrom([&] { connection.execute("DELETE FROM alignment_decision"); }), DbFault::kAppendOnly);
}

TEST_F(DiscrepancyRepositoryTest, RejectsInvalidDecisionsWithoutAnEntry) {
  Connection connection = openWithSchema();
  SampleRecord sample(connection, 1);
  const std::string id = assignmentIn(connection, sample);
  DiscrepancyRepository decisions(connection);
  EXPECT_EQ(faultFrom([&] {
              decisions.add({"none", 0, DiscrepancyChoice::kKeep, "", "admin", 0});
            }),
            DbFault::kForeignKey);
  EXPECT_TRUE(AuditRepository(connection).entries().empty());
}

class FreezeRepositoryTest : public DatabaseTest {};

TEST_F(FreezeRepositoryTest, AFrozenDataSetIsFoundByNameAndImmutable) {
  Connection connection = openWithSchema();
  SampleRecord sample(connection, 1);
  FreezeRepository freezes(connection, "room 1");
  const DataFreeze freeze{sample.ids.newUuid(), sample.cohort.id, "Autumn, final", "0a1b",
                          R"({"marks":12})",    "admin",          kSampleTime_us,  true};

  freezes.add(freeze);
  freezes.add(freeze);

  ASSERT_EQ(freezes.list(sample.cohort.id).size(), 1U);
  const DataFreeze found = freezes.findByName("Autumn, final").value();
  EXPECT_EQ(found.id, freeze.id);
  EXPECT_EQ(found.contentHash, "0a1b");
  EXPECT_EQ(found.manifestJson, R"({"marks":12})");
  EXPECT_EQ(found.createdUtc_us, kSampleTime_us);
  EXPECT_FALSE(freezes.findByName("Spring").has_value());
  EXPECT_EQ(AuditRepository(connection).entries().size(), 1U);
  DataFreeze other = freeze;
  other.contentHash = "ffff";
  EXPECT_EQ(faultFrom([&] { freezes.add(other); }), DbFault::kUnique);
  other.id = sample.ids.newUuid();
  EXPECT_EQ(faultFrom([&] { freezes.add(other); }), DbFault::kUnique);
  EXPECT_EQ(faultFrom([&] { connection.execute("UPDATE frozen_dataset SET name = ?", {"x"}); }),
            DbFault::kAppendOnly);
}

}  // namespace
}  // namespace torsio
