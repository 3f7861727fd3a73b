// SPDX-License-Identifier: GPL-3.0-or-later
// A record with the first released schema (tests/data/records, made by write_first_release): every later
// version opens and migrates it and finds all its contents.
#include <filesystem>
#include <string>

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/migrations/backup.h"
#include "db/migrations/migrations.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/record_copy.h"
#include "db/repository/system/schema_tables.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/servo/replay_trial.h"
#include "tests/db/test_database.h"
#include "tests/sim/servo/recorded_bar.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

class FirstReleaseTest : public DatabaseTest {
 protected:
  /// Opens a writable copy.
  [[nodiscard]] Connection openCopy() const {
    const fs::path copy = folder_.path() / "record.sqlite";
    fs::copy_file(fs::path(TORSIO_TEST_DATA) / "records" / "schema_0001.sqlite", copy,
                  fs::copy_options::overwrite_existing);
    fs::permissions(copy, fs::perms::owner_read | fs::perms::owner_write);
    return openRecord(copy.string(), OpenMode::kReadWrite, {.softwareVersion = "test"});
  }
  static void expectWhole(Connection& record) {
    EXPECT_TRUE(integrityFindings(record).empty());
    for (const AuditFinding& finding : verifyAuditTrail(record)) {
      ADD_FAILURE() << finding.objectKind << " " << finding.objectId << ": " << finding.what;
    }
    const ReplayReport report = replayTrial(recordedBar(), TrialRepository(record).load("first-release"));
    EXPECT_EQ(report.samples, 8'000);
    EXPECT_TRUE(report.identical()) << (report.first ? report.first->field : "");
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(FirstReleaseTest, IsOpenedMigratedVerifiedAndReplayed) {
  Connection record = openCopy();

  const SchemaState state = checkSchema(record, embeddedMigrations());

  EXPECT_EQ(state.version, embeddedMigrations().back().version);
  expectWhole(record);
}

TEST_F(FirstReleaseTest, HasARowInEveryTable) {
  Connection record = openCopy();

  for (const SchemaTable& table : tablesInReferenceOrder(record)) {
    if (table.name == "erasure_gate") {
      continue;  // empty outside a transaction
    }
    EXPECT_GT(numberFrom(record, "SELECT count(*) FROM " + table.name), 0) << table.name;
  }
}

TEST_F(FirstReleaseTest, CanBeCopiedToTheEngineOfThisSuite) {
  Connection record = openCopy();
  Connection target = openWithSchema();

  const CopyReport report = copyRecord(record, target);

  EXPECT_GT(report.rows, 80);
  expectWhole(target);
}

}  // namespace
}  // namespace torsio
