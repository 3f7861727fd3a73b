// SPDX-License-Identifier: GPL-3.0-or-later

#include "db/repository/base/audit_repository.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/audit_terms.h"
#include "assessment/domain/rating/mark.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/db/sample_record.h"

namespace torsio {

namespace {

class AuditRepositoryTest : public SampleTest {
 protected:
  AuditRepository audit() { return AuditRepository(connection()); }
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
  audit().append(entryOf(AuditAction::kPersonChange, 10));
  audit().append(entryOf(AuditAction::kReportExportNamed, 20));

  const std::vector<AuditEntry> entries = audit().entries();

  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].action, "report.export_named");
  EXPECT_EQ(entries[0].sequence, 2);
  EXPECT_EQ(entries[0].previousHash, entries[1].entryHash);
  EXPECT_EQ(entries[1].reason, "typing error");
  EXPECT_EQ(entries[1].newJson, R"({"level":"2"})");
  EXPECT_EQ(audit().entries({.fromUtc_us = 11}).size(), 1U);
  EXPECT_TRUE(audit().entries({.objectKind = AuditObject::kTrial}).empty());
  EXPECT_TRUE(verifyAuditTrail(connection()).empty());
}

TEST_F(AuditRepositoryTest, ListsTheNewestOfATimeRangeWhetherFewOrMany) {
  // Clocks of stations differ: the third entry was made after the fourth, but has an earlier time.
  for (const std::int64_t at_us : {10, 20, 40, 30, 50}) {
    audit().append(entryOf(AuditAction::kPersonChange, at_us));
  }
  const auto listed = [&](const AuditFilter& filter) {
    std::vector<std::int64_t> sequences;
    for (const AuditEntry& entry : audit().entries(filter)) {
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
  {
    const Transaction transaction(connection());
    AuditRepository(connection()).append(entryOf(AuditAction::kPersonChange, 10));
  }
  EXPECT_TRUE(AuditRepository(connection()).entries().empty());
}

TEST_F(AuditRepositoryTest, CannotBeChangedEvenDuringAnErase) {
  AuditRepository(connection()).append(entryOf(AuditAction::kPersonChange, 10));
  connection().execute("INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES (?, ?, ?)", {"x", "", 0});

  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM audit_entry"); }), DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE audit_entry SET actor = ?", {"x"}); }),
            DbFault::kAppendOnly);
}

TEST_F(AuditRepositoryTest, DetectsAChangedAndARemovedEntry) {
  for (int i = 0; i < 4; ++i) {
    audit().append(entryOf(AuditAction::kPersonChange, i));
  }
  dropTriggers(connection(), "audit_entry");

  connection().execute("UPDATE audit_entry SET actor = ? WHERE sequence = ?", {"nobody", 2});
  std::vector<AuditFinding> findings = verifyAuditTrail(connection());
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].sequence, 2);

  connection().execute("DELETE FROM audit_entry WHERE sequence = ?", {2});
  findings = verifyAuditTrail(connection());
  ASSERT_EQ(findings.size(), 2U);  // a gap before 3, and 3 does not follow 1
  EXPECT_EQ(findings[0].sequence, 3);
}

TEST_F(AuditRepositoryTest, SealsEachMarkAndDetectsAChangedOne) {
  const std::string id = recordMark(connection(), sample());
  const AuditEntry entry = audit().entries({.objectKind = AuditObject::kTrainingMark}).at(0);
  EXPECT_EQ(entry.action, "mark.submit");
  EXPECT_EQ(entry.actor, sample().chiefs[0].person.id);
  EXPECT_EQ(entry.station, "ward");
  EXPECT_TRUE(verifyAuditTrail(connection()).empty());
  dropTriggers(connection(), "training_mark");

  Connection behind = open();  // with another tool
  behind.execute("UPDATE training_mark SET score_steps = ?", {100});
  const std::vector<AuditFinding> changed = verifyAuditTrail(connection());
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(changed[0].objectId, id);

  behind.execute("UPDATE training_mark SET score_steps = ?, comment = ?", {40, "wild"});
  ASSERT_EQ(verifyAuditTrail(connection()).size(), 1U);

  behind.execute("DELETE FROM training_mark");
  EXPECT_EQ(verifyAuditTrail(connection()).at(0).what, "was recorded, but is missing");
}

TEST_F(AuditRepositoryTest, DetectsAnInsertedMark) {
  open().execute(
      "INSERT INTO training_mark (id, enrolment_id, rater_id, occasion, version, score_steps, "
      "scale_lo_steps,"
      " scale_hi_steps, steps_per_point, submitted_utc_us, demonstration)"
      " VALUES ('x', ?, ?, 'pre', 1, 100, 10, 100, 10, 0, ?)",
      {sample().enrolments[0].id, sample().chiefs[0].person.id, true});

  const std::vector<AuditFinding> findings = verifyAuditTrail(connection());

  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].what, "is present, but was never recorded");
}

TEST_F(AuditRepositoryTest, DetectsAChangedByteOfARecording) {
  const std::string id = recordTrial(connection(), sample());
  EXPECT_TRUE(verifyAuditTrail(connection()).empty());
  dropTriggers(connection(), "trial_chunk");
  Blob bytes = sampleChunk(1, 300).bytes;
  bytes[17] ^= std::byte{1};

  connection().execute("UPDATE trial_chunk SET bytes = ? WHERE chunk_index = ?", {bytes, 1});

  const std::vector<AuditFinding> findings = verifyAuditTrail(connection());
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].objectId, id);
  EXPECT_NE(findings[0].what.find("chunk 1"), std::string::npos) << findings[0].what;
}

TEST_F(AuditRepositoryTest, RefusesToImportACorruptRecording) {
  const std::string id = recordTrial(connection(), sample());
  Trial trial = TrialRepository(connection()).load(id);
  trial.header.trialId = sample().ids.newUuid();

  EXPECT_EQ(refusalFrom([&] { TrialRepository(connection()).import(trial); }).code, ErrorCode::kVerifyFailed);
  EXPECT_EQ(TrialRepository(connection()).list().size(), 1U);
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

namespace {

template <typename TermValue>
class AuditTerms : public ::testing::Test {};
using Kinds = ::testing::Types<AuditAction, AuditObject>;
TYPED_TEST_SUITE(AuditTerms, Kinds);

TYPED_TEST(AuditTerms, ConvertToTheirTextAndBack) {
  for (const Term<TypeParam>& term : termsOf(TypeParam{})) {
    EXPECT_EQ(storedText(term.value), term.stored);
    EXPECT_EQ(fromStoredText<TypeParam>(term.stored), term.value);
  }
  EXPECT_EQ(fromStoredText<TypeParam>(""), std::nullopt);
  EXPECT_EQ(fromStoredText<TypeParam>("mark.polish"), std::nullopt);
}

TYPED_TEST(AuditTerms, HaveUniqueTextsAndLabels) {
  std::set<std::string_view> texts;
  std::set<std::string_view> labels;
  for (const Term<TypeParam>& term : termsOf(TypeParam{})) {
    EXPECT_TRUE(texts.insert(term.stored).second) << term.stored;
    EXPECT_TRUE(labels.insert(term.label.english()).second) << term.label.english();
    EXPECT_EQ(term.label.english().find_first_of("._"), std::string_view::npos) << term.label.english();
  }
}

TYPED_TEST(AuditTerms, AreIncompleteWithoutOneOfThem) {
  constexpr auto& kWhole = termsOf(TypeParam{});
  std::array<Term<TypeParam>, kWhole.size() - 1> tooShort{};
  std::copy(kWhole.begin(), kWhole.end() - 1, tooShort.begin());
  std::array<Term<TypeParam>, kWhole.size()> swapped = kWhole;
  std::swap(swapped[0], swapped[1]);

  EXPECT_TRUE(isWholeTable(kWhole, TypeParam::kEnd));
  EXPECT_FALSE(isWholeTable(tooShort, TypeParam::kEnd));
  EXPECT_FALSE(isWholeTable(swapped, TypeParam::kEnd));
}

// Frozen: records of the first release contain them.
TEST(AuditTermTexts, OfTheFirstReleaseAreFrozen) {
  EXPECT_EQ(storedText(AuditAction::kMarkSubmit), "mark.submit");
  EXPECT_EQ(storedText(AuditAction::kUserSignInFailed), "user.sign_in_failed");
  EXPECT_EQ(storedText(AuditAction::kRetentionExtend), "retention.extend");
  EXPECT_EQ(storedText(AuditAction::kDiscrepancyAdjudicator), "alignment.third");
  EXPECT_EQ(storedText(AuditAction::kCurriculumClosed), "curriculum.closed");
  EXPECT_EQ(storedText(AuditAction::kDatabaseRestore), "database.restore");
  EXPECT_EQ(storedText(AuditAction::kDemonstrationRemove), "demonstration.remove");
  EXPECT_EQ(storedText(AuditObject::kTrainingMark), "training_mark");
  EXPECT_EQ(storedText(AuditObject::kEvaluationMark), "evaluation_mark");
  EXPECT_EQ(storedText(AuditObject::kTrial), "trial");
}

TEST(AuditLabels, DescribeActionAndObject) {
  EXPECT_EQ(labelOfStored<AuditAction>("mark.submit").str(), "Mark submitted");
  EXPECT_EQ(labelOfStored<AuditObject>("training_mark").str(), "mark");
}

TEST(AuditLabels, KeepCodesOfOtherVersions) {
  EXPECT_EQ(labelOfStored<AuditAction>("mark.polish").str(), "mark.polish");
  EXPECT_EQ(labelOfStored<AuditObject>("polish").str(), "polish");
}

}  // namespace

}  // namespace torsio
