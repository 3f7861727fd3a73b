// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/record_copy.h"

#include <set>

#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/schema_tables.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

/// Copies between the engine of the suite and an SQLite file, both ways.
class RecordCopyTest : public DatabaseTest {
 protected:
  [[nodiscard]] Connection file(const std::string& name) const {
    return openRecord((folder_.path() / name).string(), OpenMode::kCreate, {.softwareVersion = "test"});
  }
  static std::vector<TableDigest> digests(Connection& connection) {
    Transaction transaction(connection);
    std::vector<TableDigest> all;
    for (const SchemaTable& table : tablesInReferenceOrder(connection)) {
      all.push_back(digestOf(connection, table));
    }
    return all;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(RecordCopyTest, TablesFollowTheirParents) {
  const std::vector<SchemaTable> tables = tablesInReferenceOrder(connection());

  std::set<std::string> seen;
  std::size_t references = 0;
  for (const SchemaTable& table : tables) {
    for (const TableReference& reference : table.references) {
      EXPECT_TRUE(reference.parent == table.name || seen.contains(reference.parent)) << table.name;
      EXPECT_EQ(reference.columns.size(), reference.parentColumns.size());
      ++references;
    }
    seen.insert(table.name);
  }
  EXPECT_GE(tables.size(), 60U);
  EXPECT_GE(references, 90U);
  EXPECT_TRUE(seen.contains("training_mark_row"));
  EXPECT_FALSE(seen.contains("schema_migration"));
}

TEST_F(RecordCopyTest, TheOrderIsTheSameOnBothEngines) {
  Connection here = openWithSchema();
  Connection there = file("other.sqlite");
  const std::vector<SchemaTable> a = tablesInReferenceOrder(here);
  const std::vector<SchemaTable> b = tablesInReferenceOrder(there);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].columnList(), b[i].columnList());
    EXPECT_EQ(a[i].references.size(), b[i].references.size());
  }
}

TEST_F(RecordCopyTest, CopiesEveryRowOfEveryTableThereAndBack) {
  Connection original = file("original.sqlite");
  const FullRecord real(original, "real", false);
  const FullRecord simulated(original, "demo", true);
  Connection middle = openWithSchema();

  const CopyReport there = copyRecord(original, middle);
  Connection back = file("back.sqlite");
  const CopyReport andBack = copyRecord(middle, back);

  EXPECT_EQ(there.tables, andBack.tables);
  EXPECT_EQ(digests(original), digests(back));
  EXPECT_EQ(digests(original), digests(middle));
  for (const TableDigest& table : there.tables) {
    const bool ofServers = table.table == "erasure_gate" || table.table == "password_pepper";
    EXPECT_TRUE(table.rows > 0 || ofServers) << table.table;
  }
  EXPECT_EQ(there.auditEntries, AuditRepository(original).length());
  EXPECT_TRUE(verifyAuditTrail(middle).empty());
  EXPECT_EQ(TrialRepository(back).load(real.trialId).chunks.size(), 2U);
  EXPECT_EQ(faultFrom([&] { middle.execute("DELETE FROM training_mark"); }), DbFault::kAppendOnly);
}

TEST_F(RecordCopyTest, RefusesANonemptyTarget) {
  Connection original = file("original.sqlite");
  const FullRecord real(original, "real", false);
  Connection used = openWithSchema();
  used.execute("INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?)", {"language", "en", 1});
  const std::vector<TableDigest> before = digests(used);

  const Refusal refusal = refusalFrom([&] { (void)copyRecord(original, used); });

  EXPECT_EQ(refusal.code, ErrorCode::kBadData);
  EXPECT_NE(refusal.text.find("the target is not empty: it has rows in the table "), std::string::npos)
      << refusal.text;
  EXPECT_EQ(digests(used), before);
}

TEST_F(RecordCopyTest, LeavesNothingWhenCancelled) {
  Connection original = file("original.sqlite");
  const FullRecord real(original, "real", false);
  for (int i = 0; i < 1200; ++i) {
    original.execute("INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?)",
                     {std::string("s").append(std::to_string(i)), "", 1});
  }
  Connection target = openWithSchema();
  const std::vector<TableDigest> before = digests(target);
  const auto stop = [](const CopyStep& step) {
    if (step.phase == CopyPhase::kCopying) {
      throw Error(ErrorCode::kUsage, Text::verbatim("stopped"), "", "");
    }
  };

  EXPECT_EQ(refusalFrom([&] { (void)copyRecord(original, target, stop); }).code, ErrorCode::kUsage);

  EXPECT_EQ(digests(target), before);
  EXPECT_GT(copyRecord(original, target).rows, 1200);
}

TEST_F(RecordCopyTest, RefusesARecordWhoseTrailDoesNotVerify) {
  Connection original = file("original.sqlite");
  const FullRecord real(original, "real", false);
  original.executeVerbatim("DROP TRIGGER training_mark_no_UPDATE");
  original.execute("UPDATE training_mark SET score_steps = ?", {100});
  Connection target = openWithSchema();

  const Refusal refusal = refusalFrom([&] { (void)copyRecord(original, target); });

  EXPECT_EQ(refusal.code, ErrorCode::kBadData);
  EXPECT_NE(refusal.text.find("its audit trail does not verify"), std::string::npos) << refusal.text;
}

TEST_F(RecordCopyTest, AHashDependsOnEachValueButNotOnTheOrder) {
  const auto put = [&](const char* name, const char* value) {
    connection().execute("INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?)",
                         {name, value, 1});
  };
  const auto hash = [&] {
    Transaction transaction(connection());
    for (const SchemaTable& table : tablesInReferenceOrder(connection())) {
      if (table.name == "setting") {
        return digestOf(connection(), table).hash;
      }
    }
    return std::string();
  };
  put("a", "1");
  put("b", "2");
  const std::string ab = hash();
  connection().execute("DELETE FROM setting");
  put("b", "2");
  put("a", "1");
  EXPECT_EQ(hash(), ab);
  connection().execute("UPDATE setting SET value = ? WHERE name = ?", {"3", "a"});
  EXPECT_NE(hash(), ab);
}

}  // namespace
}  // namespace torsio
