// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody with the file in hand could do to hide a change, on both engines.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/people/audit_entry.h"
#include "assessment/rating/mark.h"
#include "db/connection/connection.h"
#include "db/migrations/schema_check.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

/// A record with one sealed mark.
class TamperTest : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    connection_.emplace(openWithSchema());
    SampleRecord sample(*connection_, 2);
    SubmittedMark mark;
    mark.id = sample.ids.newUuid();
    mark.enrolmentId = sample.enrolments[0].id;
    mark.raterId = sample.chiefs[0].person.id;
    mark.occasionCode = "pre";
    mark.score_steps = 40;
    mark.submittedUtc_us = kSampleTime_us;
    RatingRepository(*connection_, "ward").submit(std::span(&mark, 1));
    markId_ = mark.id;
  }
  void TearDown() override {
    connection_.reset();
    DatabaseTest::TearDown();
  }

  void dropTriggers(const std::string& table) {
    for (const std::string& trigger : onPostgresql() ? std::vector<std::string>{"_append_only"}
                                                     : std::vector<std::string>{"_no_UPDATE", "_no_DELETE"}) {
      connection_->executeVerbatim("DROP TRIGGER " + table + trigger +
                                   (onPostgresql() ? " ON " + table : ""));
    }
  }
  /// An entry as Torsio writes it, hashes and all.
  void forgeEntry(AuditAction action, const std::string& hash) {
    AuditRepository(*connection_)
        .append({.atUtc_us = kSampleTime_us,
                 .actor = "somebody",
                 .station = "ward",
                 .action = action,
                 .objectKind = AuditObject::kTrainingMark,
                 .objectId = markId_,
                 .objectHash = hash});
  }
  [[nodiscard]] bool finds(const std::string& what) {
    const std::vector<AuditFinding> findings = verifyAuditTrail(*connection_);
    return std::any_of(findings.begin(), findings.end(), [&](const AuditFinding& finding) {
      return finding.what.find(what) != std::string::npos;
    });
  }

  std::optional<Connection> connection_;
  std::string markId_;
};

TEST_F(TamperTest, AnUntouchedRecordHasNoFinding) {
  EXPECT_TRUE(schemaFindings(*connection_).empty());
  EXPECT_TRUE(verifyAuditTrail(*connection_).empty());
}

TEST_F(TamperTest, ATriggerThatWasTakenAwayIsNamed) {
  dropTriggers("training_mark");

  const std::vector<SchemaFinding> findings = schemaFindings(*connection_);

  ASSERT_EQ(findings.size(), onPostgresql() ? 1U : 2U);
  EXPECT_NE(findings[0].part.find("trigger training_mark_"), std::string::npos);
  EXPECT_NE(findings[0].what.find("missing"), std::string::npos);
}

TEST_F(TamperTest, ATriggerThatAltersWhatIsSubmittedIsNamed) {
  if (onPostgresql()) {
    connection_->executeVerbatim(
        "CREATE FUNCTION raise_score() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN NEW.score_steps = 99;"
        " RETURN NEW; END $$");
    connection_->executeVerbatim(
        "CREATE TRIGGER raise_score BEFORE INSERT ON training_mark FOR EACH ROW EXECUTE FUNCTION "
        "raise_score()");
  } else {
    connection_->executeVerbatim(
        "CREATE TRIGGER raise_score AFTER INSERT ON training_mark BEGIN UPDATE training_mark SET score_steps "
        "= 99"
        " WHERE id = NEW.id; END");
  }

  const std::vector<SchemaFinding> findings = schemaFindings(*connection_);

  ASSERT_FALSE(findings.empty());
  EXPECT_NE(findings.back().part.find("raise_score"), std::string::npos);
  EXPECT_NE(findings.back().what.find("somebody added it"), std::string::npos);
}

TEST_F(TamperTest, AGuardThatWasSwitchedOffIsNamed) {
  if (!onPostgresql()) {
    GTEST_SKIP() << "SQLite has no switch for one trigger";
  }
  connection_->executeVerbatim("ALTER TABLE training_mark DISABLE TRIGGER training_mark_append_only");
  connection_->executeVerbatim(
      "CREATE OR REPLACE FUNCTION refuse_thaw() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RETURN NEW; END "
      "$$");

  EXPECT_EQ(schemaFindings(*connection_).size(), 2U);
}

TEST_F(TamperTest, AChangedMarkWithASecondSealIsFound) {
  dropTriggers("training_mark");
  connection_->executeVerbatim("UPDATE training_mark SET score_steps = 90");
  forgeEntry(AuditAction::kMarkSubmit, std::string(64, 'a'));

  EXPECT_TRUE(finds("seals a row otherwise that was sealed before"));
  EXPECT_TRUE(finds("differs from what was recorded"));
}

TEST_F(TamperTest, ADeletedMarkWithAnEntryOfItsRemovalIsFound) {
  dropTriggers("training_mark");
  connection_->executeVerbatim("DELETE FROM training_mark");
  forgeEntry(AuditAction::kDemonstrationRemove, "");

  EXPECT_TRUE(finds("tells of a removal that did not take place"));
  EXPECT_TRUE(finds("was recorded, but is gone"));
}

TEST_F(TamperTest, ATombstoneThatSomebodyInsertedExcusesNoChangedSecond) {
  Trial trial;
  trial.header = sampleHeader("11111111-1111-4111-8111-111111111111", "T-01");
  TrialChunk chunk = sampleChunk(0, 300);
  chunk.digest = chunkDigest(chunk);
  trial.chunks.push_back(chunk);
  trial.summary.samples = chunk.samples;
  trial.summary.contentHash = contentHash(trial);
  TrialRepository(*connection_, {.station = "ward"}).import(trial);
  ASSERT_TRUE(verifyAuditTrail(*connection_).empty());
  dropTriggers("trial_chunk");
  connection_->execute("UPDATE trial_chunk SET bytes = ?", {Blob(300)});
  connection_->executeVerbatim(
      "INSERT INTO erasure (person_id, requested_by, reason, erased_utc_us)"
      " SELECT trainee_id, 'somebody', 'none', 1 FROM trial");

  EXPECT_FALSE(verifyAuditTrail(*connection_).empty());
}

TEST_F(TamperTest, ARightThatWasGivenToTraineesIsNamed) {
  connection_->execute("INSERT INTO role_operation (role_code, operation_code) VALUES (?, ?)",
                       {"trainee", "user.manage"});
  connection_->execute("DELETE FROM role_operation WHERE role_code = ? AND operation_code = ?",
                       {"administrator", "audit.view"});

  const std::vector<SchemaFinding> findings = schemaFindings(*connection_);

  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].part, "right administrator audit.view");
  EXPECT_EQ(findings[1].part, "right trainee user.manage");
}

TEST_F(TamperTest, AGateThatWasLeftOpenIsFound) {
  connection_->execute("INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES (?, ?, ?)",
                       {"x", "none", 1});

  EXPECT_TRUE(finds("is open: sealed rows can be changed"));
}

}  // namespace
}  // namespace torsio
