// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/audit_repository.h"

#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/rating/mark.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

class AuditRepositoryTest : public DatabaseTest {
 protected:
  static NewAuditEntry entryOf(AuditAction action, std::int64_t atUtc_us) {
    return {.atUtc_us = atUtc_us,
            .actor = "admin",
            .station = "office",
            .action = action,
            .objectKind = AuditObject::kPerson,
            .objectId = "p1",
            .oldJson = "{}",
            .newJson = R"({"level":"2"})",
            .reason = "typing error"};
  }

  /// Removes the triggers, as an attacker with the file could.
  static void dropTriggers(Connection& connection, const std::string& table) {
    if (onPostgresql()) {
      connection.executeVerbatim("DROP TRIGGER " + table + "_append_only ON " + table);
    } else {
      connection.executeVerbatim("DROP TRIGGER " + table + "_no_UPDATE");
      connection.executeVerbatim("DROP TRIGGER " + table + "_no_DELETE");
    }
  }

  static std::string recordMark(Connection& connection, SampleRecord& sample) {
    SubmittedMark mark;
    mark.id = sample.ids.newUuid();
    mark.enrolmentId = sample.enrolments[0].id;
    mark.raterId = sample.chiefs[0].person.id;
    mark.occasionCode = "pre";
    mark.score_steps = 40;
    mark.comment = "calm";
    mark.submittedUtc_us = kSampleTime_us;
    RatingRepository(connection, "ward").submit(std::span(&mark, 1));
    return mark.id;
  }

  static std::string recordTrial(Connection& connection, SampleRecord& sample) {
    Trial trial;
    trial.header = sampleHeader(sample.ids.newUuid(), "T-01");
    for (std::int64_t i = 0; i < 2; ++i) {
      TrialChunk chunk = sampleChunk(i, 300);
      chunk.digest = chunkDigest(chunk);
      trial.chunks.push_back(chunk);
      trial.summary.samples += chunk.samples;
    }
    trial.summary.contentHash = contentHash(trial);
    TrialRepository(connection, {"ward", ""}).import(trial);
    return trial.header.trialId;
  }
};

TEST_F(AuditRepositoryTest, ChainsEntriesAndListsTheNewestFirst) {
  Connection connection = openWithSchema();
  AuditRepository audit(connection);
  audit.append(entryOf(AuditAction::kPersonChange, 10));
  audit.append(entryOf(AuditAction::kReportExportNamed, 20));

  const std::vector<AuditEntry> entries = audit.entries();

  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].action, "report.export_named");
  EXPECT_EQ(entries[0].sequence, 2);
  EXPECT_EQ(entries[0].previousHash, entries[1].entryHash);
  EXPECT_EQ(entries[1].reason, "typing error");
  EXPECT_EQ(entries[1].newJson, R"({"level":"2"})");
  EXPECT_EQ(audit.entries({.fromUtc_us = 11}).size(), 1U);
  EXPECT_TRUE(audit.entries({.objectKind = AuditObject::kTrial}).empty());
  EXPECT_TRUE(verifyAuditTrail(connection).empty());
}

TEST_F(AuditRepositoryTest, ListsTheNewestOfATimeRangeWhetherFewOrMany) {
  Connection connection = openWithSchema();
  AuditRepository audit(connection);
  // Clocks of stations differ: the third entry was made after the fourth, but has an earlier time.
  for (const std::int64_t at_us : {10, 20, 40, 30, 50}) {
    audit.append(entryOf(AuditAction::kPersonChange, at_us));
  }
  const auto listed = [&audit](const AuditFilter& filter) {
    std::vector<std::int64_t> sequences;
    for (const AuditEntry& entry : audit.entries(filter)) {
      sequences.push_back(entry.sequence);
    }
    return sequences;
  };
  using Sequences = std::vector<std::int64_t>;

  EXPECT_EQ(listed({.limit = 2}), (Sequences{5, 4}));
  EXPECT_EQ(listed({.limit = 5}), (Sequences{5, 4, 3, 2, 1}));
  EXPECT_EQ(listed({.fromUtc_us = 15, .toUtc_us = 35, .limit = 1}), (Sequences{4}));
  EXPECT_EQ(listed({.fromUtc_us = 15, .toUtc_us = 35, .limit = 2}), (Sequences{4, 2}));
  EXPECT_EQ(listed({.fromUtc_us = 35, .limit = INT64_MAX}), (Sequences{5, 3}));
  EXPECT_EQ(listed({.fromUtc_us = 60}), Sequences{});
}

TEST_F(AuditRepositoryTest, RollsBackWithItsChange) {
  Connection connection = openWithSchema();
  {
    const Transaction transaction(connection);
    AuditRepository(connection).append(entryOf(AuditAction::kPersonChange, 10));
  }
  EXPECT_TRUE(AuditRepository(connection).entries().empty());
}

TEST_F(AuditRepositoryTest, CannotBeChangedEvenDuringAnErase) {
  Connection connection = openWithSchema();
  AuditRepository(connection).append(entryOf(AuditAction::kPersonChange, 10));
  connection.execute("INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES (?, ?, ?)", {"x", "", 0});

  EXPECT_EQ(faultFrom([&] { connection.execute("DELETE FROM audit_entry"); }), DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection.execute("UPDATE audit_entry SET actor = ?", {"x"}); }),
            DbFault::kAppendOnly);
}

TEST_F(AuditRepositoryTest, DetectsAChangedAndARemovedEntry) {
  Connection connection = openWithSchema();
  AuditRepository audit(connection);
  for (int i = 0; i < 4; ++i) {
    audit.append(entryOf(AuditAction::kPersonChange, i));
  }
  dropTriggers(connection, "audit_entry");

  connection.execute("UPDATE audit_entry SET actor = ? WHERE sequence = ?", {"nobody", 2});
  std::vector<AuditFinding> findings = verifyAuditTrail(connection);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].sequence, 2);

  connection.execute("DELETE FROM audit_entry WHERE sequence = ?", {2});
  findings = verifyAuditTrail(connection);
  ASSERT_EQ(findings.size(), 2U);  // a gap before 3, and 3 does not follow 1
  EXPECT_EQ(findings[0].sequence, 3);
}

TEST_F(AuditRepositoryTest, SealsEachMarkAndDetectsAChangedOne) {
  Connection connection = openWithSchema();
  SampleRecord sample(connection, 1);
  const std::string id = recordMark(connection, sample);
  AuditRepository audit(connection);
  const AuditEntry entry = audit.entries({.objectKind = AuditObject::kTrainingMark}).at(0);
  EXPECT_EQ(entry.action, "mark.submit");
  EXPECT_EQ(entry.actor, sample.chiefs[0].person.id);
  EXPECT_EQ(entry.station, "ward");
  EXPECT_TRUE(verifyAuditTrail(connection).empty());
  dropTriggers(connection, "training_mark");

  Connection behind = open();  // with another tool
  behind.execute("UPDATE training_mark SET score_steps = ?", {100});
  const std::vector<AuditFinding> changed = verifyAuditTrail(connection);
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(changed[0].objectId, id);

  behind.execute("UPDATE training_mark SET score_steps = ?, comment = ?", {40, "wild"});
  ASSERT_EQ(verifyAuditTrail(connection).size(), 1U);

  behind.execute("DELETE FROM training_mark");
  EXPECT_EQ(verifyAuditTrail(connection).at(0).what, "was recorded, but is gone");
}

TEST_F(AuditRepositoryTest, DetectsAnInsertedMark) {
  Connection connection = openWithSchema();
  const SampleRecord sample(connection, 1);
  open().execute(
      "INSERT INTO training_mark (id, enrolment_id, rater_id, occasion, version, score_steps, "
      "scale_lo_steps,"
      " scale_hi_steps, steps_per_point, submitted_utc_us, demonstration)"
      " VALUES ('x', ?, ?, 'pre', 1, 100, 10, 100, 10, 0, ?)",
      {sample.enrolments[0].id, sample.chiefs[0].person.id, true});

  const std::vector<AuditFinding> findings = verifyAuditTrail(connection);

  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].what, "is there, but was never recorded");
}

TEST_F(AuditRepositoryTest, DetectsAChangedByteOfARecording) {
  Connection connection = openWithSchema();
  SampleRecord sample(connection, 1);
  const std::string id = recordTrial(connection, sample);
  AuditRepository audit(connection);
  EXPECT_TRUE(verifyAuditTrail(connection).empty());
  dropTriggers(connection, "trial_chunk");
  Blob bytes = sampleChunk(1, 300).bytes;
  bytes[17] ^= std::byte{1};

  connection.execute("UPDATE trial_chunk SET bytes = ? WHERE chunk_index = ?", {bytes, 1});

  const std::vector<AuditFinding> findings = verifyAuditTrail(connection);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].objectId, id);
  EXPECT_NE(findings[0].what.find("chunk 1"), std::string::npos) << findings[0].what;
}

TEST_F(AuditRepositoryTest, RefusesToImportACorruptRecording) {
  Connection connection = openWithSchema();
  SampleRecord sample(connection, 1);
  const std::string id = recordTrial(connection, sample);
  Trial trial = TrialRepository(connection).load(id);
  trial.header.trialId = sample.ids.newUuid();

  EXPECT_EQ(refusalFrom([&] { TrialRepository(connection).import(trial); }).code, ErrorCode::kVerifyFailed);
  EXPECT_EQ(TrialRepository(connection).list().size(), 1U);
}

TEST_F(AuditRepositoryTest, TwoStationsWriteOneChain) {
  Connection first = openWithSchema();
  Connection second = open();
  for (int i = 0; i < 5; ++i) {
    AuditRepository(first).append(entryOf(AuditAction::kPersonAdd, i));
    AuditRepository(second).append(entryOf(AuditAction::kPersonChange, i));
  }
  EXPECT_EQ(AuditRepository(first).entries().size(), 10U);
  EXPECT_TRUE(verifyAuditTrail(second).empty());
}

}  // namespace
}  // namespace torsio
