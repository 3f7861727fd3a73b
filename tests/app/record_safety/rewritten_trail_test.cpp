// SPDX-License-Identifier: GPL-3.0-or-later
// Consistent forgeries, detected by a head stored elsewhere, on both engines.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/session_context.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/copies.h"
#include "assessment/domain/people/account.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "tests/app/record_safety/killed_maintenance.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"
#include "tests/support/compared_heads.h"

namespace torsio {
namespace {

/// A record with some marks, and the head of its trail at that time.
class RewrittenTrail : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    key_ = (folder_.path() / "key").string();
    public_ = makeAnchorKey(key_);
    connection_.emplace(openWithSchema());
    sample_.emplace(*connection_, 2);
    submit(1, 0);
  }
  void TearDown() override {
    connection_.reset();
    DatabaseTest::TearDown();
  }

  /// Submits versions `from` .. `from + more` of one mark.
  void submit(int from, int more) {
    for (int version = from; version <= from + more; ++version) {
      SubmittedMark mark;
      mark.id = "mark " + std::to_string(version);
      mark.enrolmentId = sample_->enrolments[0].id;
      mark.raterId = sample_->chiefs[0].person.id;
      mark.occasionCode = "pre";
      mark.version = version;
      mark.score_steps = 40;
      mark.amendReason = version == 1 ? "" : "looked again";
      mark.submittedUtc_us = kSampleTime_us + version;
      RatingRepository(*connection_, "ward").submit(std::span(&mark, 1));
    }
  }
  void recordTrial() { TrialRepository(*connection_, {.station = "ward"}).import(sampleTrial()); }
  [[nodiscard]] std::string head() const { return anchoredHead(locator(), key_, kSampleTime_us); }
  [[nodiscard]] std::int64_t length() {
    return numberFrom(*connection_, "SELECT max(sequence) FROM audit_entry");
  }
  /// Opens the record as an attacker with another tool and all protections off.
  [[nodiscard]] Connection pryOpen() const {
    Connection behind = open();
    disarm(behind);
    return behind;
  }
  [[nodiscard]] std::size_t foundWith(const std::string& kept) const {
    return compareWithHeads(locator(), {kept}, public_).size();
  }

  TemporaryFolder folder_;
  std::string key_;
  std::string public_;
  std::optional<Connection> connection_;
  std::optional<SampleRecord> sample_;
};

TEST_F(RewrittenTrail, ARecordThatOnlyGrewMatchesItsHead) {
  const std::string kept = head();
  submit(2, 3);
  EXPECT_EQ(foundWith(kept), 0U);
}

TEST_F(RewrittenTrail, ADeletedLatestEntryIsDetected) {
  const std::string kept = head();
  Connection behind = pryOpen();

  behind.executeVerbatim("DELETE FROM audit_entry WHERE sequence = (SELECT max(sequence) FROM audit_entry)");

  EXPECT_EQ(foundWith(kept), 1U);
}

TEST_F(RewrittenTrail, DeletingTheLast40EntriesWithTheirMarksAndTrialsIsDetected) {
  const std::string before = std::to_string(length());
  submit(2, 19);
  recordTrial();
  ASSERT_GE(length(), std::stoll(before) + 40);
  const std::string kept = head();
  Connection behind = pryOpen();

  behind.executeVerbatim("DELETE FROM training_mark WHERE version > 1");
  for (const char* table : {"trial_chunk", "trial_end"}) {
    behind.executeVerbatim(std::string("DELETE FROM ") + table);
  }
  behind.executeVerbatim("DELETE FROM trial");
  behind.executeVerbatim("DELETE FROM row_seal WHERE entry_sequence > " + before);
  behind.executeVerbatim("DELETE FROM audit_entry WHERE sequence > " + before);

  EXPECT_TRUE(verifyAuditTrail(behind).empty()) << "the record alone tells nothing";
  EXPECT_EQ(foundWith(kept), 1U);
}

TEST_F(RewrittenTrail, AChangedMarkWithTheWholeChainRewrittenIsDetected) {
  const std::string kept = head();
  Connection behind = pryOpen();
  behind.executeVerbatim("UPDATE training_mark SET score_steps = 95");
  ASSERT_FALSE(verifyAuditTrail(behind).empty());

  rewriteTrail(behind);

  EXPECT_TRUE(verifyAuditTrail(behind).empty()) << "the record alone tells nothing";
  EXPECT_EQ(foundWith(kept), 1U);
}

TEST_F(RewrittenTrail, AnOlderRecordPutBackIsDetected) {
  const std::string older = std::to_string(length());
  submit(2, 1);
  const std::string kept = head();
  Connection behind = pryOpen();
  behind.executeVerbatim("DELETE FROM training_mark WHERE version > 1");
  behind.executeVerbatim("DELETE FROM row_seal WHERE entry_sequence > " + older);
  behind.executeVerbatim("DELETE FROM audit_entry WHERE sequence > " + older);

  EXPECT_EQ(foundWith(kept), 1U);
  EXPECT_EQ(foundWith(head()), 0U);
}

// A copied record leaves two: each one's register of copies, and thus an erase, names the other.

class MovedRecord : public CutOffMaintenance {
 protected:
  void SetUp() override {
    CutOffMaintenance::SetUp();
    if (IsSkipped()) {
      return;
    }
    target_ = onPostgresql() ? addressWithoutPassword() : file("moved.sqlite");
    Connection connection = openRecord(record(), OpenMode::kReadWrite);
    AccessRepository access(connection, PasswordCost::kTest);
    access.addUser({.id = "u-office", .login = "office", .roles = {kAdministratorRole}},
                   "four walls and a lamp");
  }
  [[nodiscard]] std::string record() const { return file("record.sqlite"); }
  [[nodiscard]] ProgramRun copy(const std::string& to) const {
    return run({"db", "copy", "--as-system", record(), to});
  }
  [[nodiscard]] static std::vector<std::string> placesKnownAt(const std::string& locator) {
    std::vector<std::string> places;
    for (const ListedCopy& listed : copiesOf(locator)) {
      if (listed.copy.kind == CopyKind::kMoved) {
        places.push_back(listed.copy.place);
      }
    }
    return places;
  }
  /// Returns the places that an erase at `locator` names.
  [[nodiscard]] static std::vector<std::string> namedByErase(const std::string& locator) {
    Connection connection = openRecord(locator, OpenMode::kReadWrite);
    SystemIdSource ids;
    Actor actor{.userId = "u-office", .login = "office"};
    actor.roles = {kAdministratorRole};
    SessionContext session(connection, ids, {locator, "room", actor}, utcNow_us);
    session.beginCall();
    std::vector<std::string> places;
    for (const ListedCopy& listed : copiesHolding(session, personIn(connection))) {
      places.push_back(listed.copy.place);
    }
    return places;
  }
  static bool has(const std::vector<std::string>& places, const std::string& place) {
    return std::find(places.begin(), places.end(), place) != places.end();
  }

  std::string target_;
};

TEST_F(MovedRecord, EachEndNamesTheOtherAndNotItself) {
  ASSERT_EQ(copy(target_).code, 0);
  const std::string there = parseLocator(target_).shown();

  EXPECT_EQ(placesKnownAt(record()), std::vector<std::string>{there});
  EXPECT_EQ(placesKnownAt(target_), std::vector<std::string>{record()});
  EXPECT_TRUE(has(namedByErase(target_), record())) << "the record that was left behind holds everybody";
  EXPECT_TRUE(has(namedByErase(record()), there));
  const ProgramRun listed = run({"db", "copies", "--database", target_});
  EXPECT_NE(listed.out.find("record before or after a move"), std::string::npos) << listed.out << listed.err;

  EXPECT_EQ(copy(target_).code, static_cast<int>(ErrorCode::kBadData)) << "a record is there already";
  EXPECT_EQ(placesKnownAt(record()), std::vector<std::string>{there}) << "which is still there";
  Connection moved = openRecord(target_, OpenMode::kReadWrite);
  EXPECT_TRUE(isSound(moved));
}

TEST_F(MovedRecord, ACancelledMoveIsNotListed) {
  if (onPostgresql()) {
    GTEST_SKIP() << "what is given up does not depend on the engine";
  }
  EXPECT_NE(copy(file("nowhere/moved.sqlite")).code, 0);
  EXPECT_TRUE(placesKnownAt(record()).empty());
}

}  // namespace
}  // namespace torsio
