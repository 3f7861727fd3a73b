// SPDX-License-Identifier: GPL-3.0-or-later

#include "db/migrations/migrations.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/dialect.h"
#include "db/migrations/schema_check.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/record_copy.h"
#include "db/repository/system/schema_tables.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/servo/replay_trial.h"
#include "tests/db/test_database.h"
#include "tests/sim/servo/recorded_trial.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

Migration step(std::int64_t version, const std::string& sql, std::int64_t compatibleFrom = 1) {
  return parseMigration(
      "000" + std::to_string(version) + "_test",
      "-- description: test\n-- compatible_from: " + std::to_string(compatibleFrom) + "\n" + sql);
}

const MigrationOptions kOptions{.softwareVersion = "test", .now_us = 1'700'000'000'000'000};

class MigrationsTest : public DatabaseTest {
 protected:
  [[nodiscard]] fs::path backupOf(std::int64_t version) const {
    return locator() + ".schema-" + std::to_string(version) + ".sqlite";
  }
};

TEST_F(MigrationsTest, EmbeddedMigrationsAreNumberedFromOneAndDescribed) {
  std::int64_t version = 0;
  for (const Migration& migration : embeddedMigrations()) {
    EXPECT_EQ(migration.version, ++version);
    EXPECT_FALSE(migration.description.empty());
    EXPECT_GE(migration.compatibleFrom, 1);
    EXPECT_LE(migration.compatibleFrom, migration.version);
    EXPECT_EQ(migration.checksum.size(), 64U);
  }
}

TEST_F(MigrationsTest, MigrateAnEmptyDatabaseToTheNewestSchema) {
  const SchemaState state = checkSchema(connection(), embeddedMigrations());

  EXPECT_EQ(state.version, embeddedMigrations().back().version);
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM schema_migration"), state.version);
  EXPECT_TRUE(integrityFindings(connection()).empty());
}

TEST_F(MigrationsTest, DoNothingTheSecondTime) {
  { (void)openWithSchema(); }
  Connection connection = open();

  const MigrationReport report = migrate(connection, embeddedMigrations(), kOptions);

  EXPECT_EQ(report.fromVersion, report.toVersion);
  EXPECT_FALSE(report.backup.has_value());
}

TEST_F(MigrationsTest, DoNotWaitForACopyIntoAnotherSchema) {
  if (!onPostgresql()) {
    GTEST_SKIP() << "a file holds one record";
  }
  constexpr int kPatience_ms = 500;
  Locator beside = parseLocator(locator());
  beside.schema += "_beside";
  open().executeVerbatim("CREATE SCHEMA " + beside.schema);
  {
    const NewAuditEntry entry{.atUtc_us = 1,
                              .actor = "office",
                              .station = {},
                              .action = AuditAction::kUserSignIn,
                              .objectKind = AuditObject::kAppUser};
    Connection connection = open();
    const Transaction copying(
        connection);  // a copy creates the tables and inserts the rows in one transaction
    migrate(connection, embeddedMigrations(), kOptions);
    AuditRepository(connection).append(entry);

    Connection other = openDatabase(addressOf(beside), OpenMode::kReadWrite, kPatience_ms);
    EXPECT_NO_THROW(migrate(other, embeddedMigrations(), kOptions));
    EXPECT_NO_THROW(AuditRepository(other).append(entry));

    Connection same = open(kPatience_ms);
    EXPECT_EQ(faultFrom([&] { migrate(same, embeddedMigrations(), kOptions); }), DbFault::kBusy);
  }
  Connection connection = open();
  connection.executeVerbatim("SET client_min_messages = warning");
  connection.executeVerbatim("DROP SCHEMA " + beside.schema + " CASCADE");
}

TEST_F(MigrationsTest, RefuseADatabaseOfANewerProgram) {
  Connection connection = open();
  migrate(connection, {step(1, "CREATE TABLE a (x BIGINT);\n"), step(2, "CREATE TABLE b (x BIGINT);\n", 2)},
          kOptions);

  const Refusal refusal =
      refusalFrom([&] { (void)checkSchema(connection, {step(1, "CREATE TABLE a (x BIGINT);\n")}); });

  EXPECT_EQ(refusal.code, ErrorCode::kNewerSchema);
  EXPECT_NE(refusal.text.find("schema 2"), std::string::npos) << refusal.text;
  EXPECT_NE(refusal.text.find("to version test"), std::string::npos) << "who wrote it: " << refusal.text;
}

TEST_F(MigrationsTest, AllowReadingANewerCompatibleDatabase) {
  const Migration first = step(1, "CREATE TABLE a (x BIGINT);\n");
  {
    Connection connection = open();
    migrate(connection, {first, step(2, "CREATE TABLE b (x BIGINT);\n", 1)}, kOptions);
    EXPECT_EQ(refusalFrom([&] { (void)checkSchema(connection, {first}); }).code, ErrorCode::kNewerSchema);
  }
  Connection reader = openDatabase(locator(), OpenMode::kReadOnly);
  EXPECT_EQ(checkSchema(reader, {first}).version, 2);
}

TEST_F(MigrationsTest, AForgedStepIsFoundByEveryCheck) {
  const auto forge = [this](std::int64_t version) {
    Connection connection = open();
    connection.execute("DELETE FROM schema_migration WHERE name = 'forged'", {});
    connection.execute(
        "INSERT INTO schema_migration (version, name, description, checksum, compatible_from, "
        "software_version,"
        " applied_utc_us) VALUES (?, 'forged', 'nothing', '00', 1, 'none', 1)",
        {version});
  };
  {
    Connection connection = open();
    migrate(connection, embeddedMigrations(), kOptions);
    EXPECT_TRUE(schemaFindings(connection).empty());
  }
  const std::int64_t newest = embeddedMigrations().back().version;
  forge(newest + 1'000);
  for (const OpenMode mode : {OpenMode::kReadOnly, OpenMode::kReadWrite}) {
    Connection connection = openDatabase(locator(), mode);
    const Refusal refusal = refusalFrom([&] { (void)schemaFindings(connection); });
    EXPECT_EQ(refusal.code, ErrorCode::kVerifyFailed);
    EXPECT_NE(refusal.text.find("is followed by step " + std::to_string(newest + 1'000)), std::string::npos)
        << refusal.text;
  }
  forge(newest + 1);
  Connection reader = openDatabase(locator(), OpenMode::kReadOnly);
  const std::vector<SchemaFinding> findings = schemaFindings(reader);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].part, "step " + std::to_string(newest + 1));
}

TEST_F(MigrationsTest, RefuseAMigrationThatWasEditedAfterItWasApplied) {
  Connection connection = open();
  migrate(connection, {step(1, "CREATE TABLE a (x BIGINT);\n")}, kOptions);

  const Refusal refusal =
      refusalFrom([&] { migrate(connection, {step(1, "CREATE TABLE a (y BIGINT);\n")}, kOptions); });

  EXPECT_EQ(refusal.code, ErrorCode::kVerifyFailed);
  EXPECT_NE(refusal.text.find("0001_test"), std::string::npos) << refusal.text;
}

TEST_F(MigrationsTest, KeepTheMigrationsBeforeAFailedOne) {
  Connection connection = open();
  const std::vector<Migration> steps{step(1, "CREATE TABLE a (x BIGINT);\n"),
                                     step(2, "CREATE TABLE b (x BIGINT);\nCREATE TABLE a (x BIGINT);\n")};

  EXPECT_THROW(migrate(connection, steps, kOptions), DbError);

  EXPECT_EQ(numberFrom(connection, "SELECT max(version) FROM schema_migration"), 1);
  EXPECT_THROW((void)connection.prepare("SELECT x FROM b"), DbError);
}

TEST_F(MigrationsTest, BackUpAnExistingFileBeforeTheFirstMigration) {
  if (onPostgresql()) {
    GTEST_SKIP() << "a server is backed up by its own tools";
  }
  Connection connection = open();
  const Migration first = step(1, "CREATE TABLE a (x BIGINT);\n");
  EXPECT_FALSE(migrate(connection, {first}, kOptions).backup.has_value());
  connection.execute("INSERT INTO a (x) VALUES (?)", {42});

  const MigrationReport report =
      migrate(connection, {first, step(2, "CREATE TABLE b (x BIGINT);\nDELETE FROM a;\n")}, kOptions);

  ASSERT_TRUE(report.backup.has_value());
  EXPECT_EQ(*report.backup, backupOf(1));
  Connection copy = openDatabase(report.backup->string(), OpenMode::kReadOnly);
  EXPECT_EQ(numberFrom(copy, "SELECT x FROM a"), 42);
  EXPECT_EQ(numberFrom(connection, "SELECT count(*) FROM a"), 0);
}

TEST(Dialect, ReplacesTheBlobType) {
  const std::string text = "CREATE TABLE t (b {{blob}});\n";
  EXPECT_EQ(statementsFor(Engine::kSqlite, text, "x").at(0), "CREATE TABLE t (b BLOB)");
  EXPECT_EQ(statementsFor(Engine::kPostgresql, text, "x").at(0), "CREATE TABLE t (b BYTEA)");
}

TEST(Dialect, SplitsStatementsAtSemicolonsAtTheEndOfALine) {
  const std::vector<std::string> statements =
      statementsFor(Engine::kSqlite, "-- why; indeed\nSELECT ';'\n FROM a;\nSELECT 2;\n", "x");
  ASSERT_EQ(statements.size(), 2U);
  EXPECT_EQ(statements[0], "SELECT ';'\n FROM a");
}

TEST(Dialect, RejectsUnknownTokensAndUnterminatedStatements) {
  EXPECT_EQ(refusalFrom([] { (void)statementsFor(Engine::kSqlite, "{{nonsense}}\n", "x"); }).code,
            ErrorCode::kBadData);
  EXPECT_EQ(refusalFrom([] { (void)statementsFor(Engine::kSqlite, "A {{nonsense}};\n", "x"); }).code,
            ErrorCode::kBadData);
  EXPECT_EQ(refusalFrom([] { (void)statementsFor(Engine::kSqlite, "SELECT 1\n", "x"); }).code,
            ErrorCode::kBadData);
}

class BackupTest : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (onPostgresql()) {
      GTEST_SKIP() << "a server is backed up by its own tools";
    }
  }
};

TEST_F(BackupTest, IsASingleCompleteFile) {
  connection().execute("INSERT INTO rater_class (code, label, position) VALUES (?, ?, ?)",
                       {"chief", "chiefs", 3});
  const fs::path target = locator() + ".copy";

  backupSqlite(connection(), target);

  Connection copy = openRecord(target.string(), OpenMode::kReadOnly);
  EXPECT_EQ(numberFrom(copy, "SELECT count(*) FROM rater_class"), 1);
  EXPECT_FALSE(fs::exists(locator() + ".copy.part"));
  EXPECT_FALSE(fs::exists(locator() + ".copy.part-wal"));
}

TEST_F(BackupTest, LeavesNothingIfItsFolderIsMissing) {
  EXPECT_THROW(backupSqlite(connection(), fs::path(locator()).parent_path() / "none" / "copy.sqlite"), Error);
  EXPECT_FALSE(fs::exists(fs::path(locator()).parent_path() / "none"));
}

TEST_F(BackupTest, IsRestoredOverAnUnusedDatabase) {
  const fs::path copy = locator() + ".copy";
  {
    Connection connection = openWithSchema();
    connection.execute("INSERT INTO rater_class (code, label, position) VALUES (?, ?, ?)",
                       {"a", "before", 1});
    backupSqlite(connection, copy);
    connection.execute("UPDATE rater_class SET label = ?", {"after"});
    EXPECT_EQ(refusalFrom([&] { restoreSqlite(copy, locator()); }).code, ErrorCode::kDatabase);
    EXPECT_EQ(numberFrom(connection, "SELECT count(*) FROM rater_class WHERE label = 'after'"), 1);
  }

  restoreSqlite(copy, locator());

  Connection restored = openWithSchema();
  EXPECT_EQ(numberFrom(restored, "SELECT count(*) FROM rater_class WHERE label = 'before'"), 1);
  Connection aside = openDatabase(locator() + ".before-restore-1", OpenMode::kReadOnly);
  EXPECT_EQ(numberFrom(aside, "SELECT count(*) FROM rater_class WHERE label = 'after'"), 1);
}

TEST_F(BackupTest, IsCheckedBeforeItReplacesAnything) {
  const fs::path copy = locator() + ".copy";
  {
    Connection connection = openWithSchema();
    backupSqlite(connection, copy);
  }
  EXPECT_EQ(checkBackup(copy).schemaVersion, embeddedMigrations().back().version);
  EXPECT_EQ(checkBackup(copy).trials, 0);
  {
    std::fstream stream(copy, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(3 * 4096);
    stream << std::string(4096, '\xA5');
  }

  EXPECT_THROW(restoreSqlite(copy, locator()), Error);

  Connection untouched = openWithSchema();
  EXPECT_TRUE(integrityFindings(untouched).empty());
  EXPECT_FALSE(fs::exists(locator() + ".part"));
}

TEST_F(BackupTest, ReplacesADamagedDatabase) {
  const fs::path copy = locator() + ".copy";
  {
    Connection connection = openWithSchema();
    backupSqlite(connection, copy);
  }
  std::ofstream(locator(), std::ios::binary | std::ios::trunc) << "no database any more";

  restoreSqlite(copy, locator());

  Connection restored = openWithSchema();
  EXPECT_TRUE(integrityFindings(restored).empty());
  EXPECT_TRUE(fs::exists(locator() + ".before-restore-1"));
}

}  // namespace

namespace {

namespace fs = std::filesystem;

/// A record with the first released schema (tests/data/records, made by write_first_release): every later
/// version opens and migrates it and finds all its contents.
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
    static const std::set<std::string> kEmpty{"erasure_gate",  // filled only inside a transaction
                                              "run_excuse",    "study_statement",     "study_import",
                                              "watch_account", "server_session",      "password_pepper",
                                              "site",          "site_delivery",       "site_row",
                                              "second_factor", "second_factor_secret"};  // later steps
    if (kEmpty.contains(table.name)) {
      continue;
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
