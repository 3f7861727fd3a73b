// SPDX-License-Identifier: GPL-3.0-or-later
// torsio db and torsio audit through the real program, on a database with rows in every table.
#include <chrono>
#include <cstdlib>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/connection/row_reader.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "tests/app/cli/program.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

/// The address for the command line; the password comes from the environment.
std::string withoutPassword(const std::string& address) {
  Locator server = parseLocator(address);
  if (server.engine != Engine::kPostgresql) {
    return address;
  }
  setenv("PGPASSWORD", server.password.c_str(), 1);
  server.password.clear();
  return addressOf(server);
}

/// The engine of the suite is the target of copies; everything else uses SQLite files.
class DbCommandTest : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    folder_ =
        emptyFolder(std::string("db-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    Connection connection = openFile();
    const FullRecord real(connection, "real", false);
  }
  [[nodiscard]] Connection openFile() const {
    return openRecord(file("record.sqlite"), OpenMode::kCreate, {.softwareVersion = "test"});
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] ProgramRun run(const std::string& arguments) const { return runTorsio(arguments, folder_); }
  static constexpr int kVerifyFailed = static_cast<int>(ErrorCode::kVerifyFailed);

  /// Changes a mark with an SQLite tool.
  void forge(const std::string& name) const {
    Connection forged = openDatabase(file(name), OpenMode::kReadWrite);
    forged.executeVerbatim("DROP TRIGGER training_mark_no_UPDATE");
    forged.executeVerbatim("UPDATE training_mark SET score_steps = 100");
  }

  fs::path folder_;
};

TEST_F(DbCommandTest, BacksUpVerifiesAndRestores) {
  const std::string database = " --database " + file("record.sqlite");
  const ProgramRun backup = run("db backup --as-system " + file("backup.sqlite") + database);
  EXPECT_EQ(backup.code, 0) << backup.err;
  EXPECT_NE(backup.out.find("Backup written and checked"), std::string::npos) << backup.out;
  EXPECT_NE(backup.out.find("1 run, 2 marks"), std::string::npos) << backup.out;
  const ProgramRun verify = run("db verify " + file("backup.sqlite"));
  EXPECT_EQ(verify.code, 0) << verify.err;
  EXPECT_NE(verify.out.find("The backup is sound"), std::string::npos) << verify.out;
  fs::resize_file(file("record.sqlite"), 100);

  const ProgramRun restore = run("db restore --as-system " + file("backup.sqlite") + database);

  EXPECT_EQ(restore.code, 0) << restore.err;
  EXPECT_NE(restore.out.find("what was there is kept"), std::string::npos) << restore.out;
  EXPECT_TRUE(fs::exists(file("record.sqlite.before-restore-1")));
  EXPECT_EQ(run("db check" + database).code, 0);
}

TEST_F(DbCommandTest, DetectsAndNamesAChangedMark) {
  const std::string database = " --database " + file("record.sqlite");
  EXPECT_EQ(run("audit verify" + database).code, 0);
  forge("record.sqlite");

  for (const char* command : {"audit verify", "db check"}) {
    const ProgramRun found = run(command + database);
    EXPECT_EQ(found.code, kVerifyFailed) << command;
    EXPECT_NE(found.out.find("training_mark real mark: differs from what was recorded"), std::string::npos)
        << found.out;
  }
  const ProgramRun json = run("audit verify --json" + database);
  EXPECT_EQ(json.code, kVerifyFailed);
  EXPECT_NE(json.out.find("\"findings\""), std::string::npos);
}

TEST_F(DbCommandTest, RejectsADamagedAndAMissingBackup) {
  ASSERT_EQ(
      run("db backup --as-system " + file("backup.sqlite") + " --database " + file("record.sqlite")).code, 0);
  forge("backup.sqlite");
  EXPECT_EQ(run("db verify " + file("backup.sqlite")).code, kVerifyFailed);
  EXPECT_EQ(
      run("db restore --as-system " + file("backup.sqlite") + " --database " + file("record.sqlite")).code,
      kVerifyFailed);
  EXPECT_EQ(run("db verify " + file("none.sqlite")).code, static_cast<int>(ErrorCode::kFileMissing));
  EXPECT_EQ(run("db check --database " + file("none.sqlite")).code,
            static_cast<int>(ErrorCode::kFileMissing));
  EXPECT_EQ(run("db").code, static_cast<int>(ErrorCode::kUsage));
}

TEST_F(DbCommandTest, BacksAServerUpIntoAFileThatRestoresTheWholeRecord) {
  if (parseLocator(locator()).engine != Engine::kPostgresql) {
    GTEST_SKIP() << "needs a server";
  }
  const std::string address = withoutPassword(locator());
  const std::string server = "'" + address + "'";
  ASSERT_EQ(run("db copy --as-system " + file("record.sqlite") + " " + server).code, 0);

  const ProgramRun backup = run("db backup --as-system " + file("backup.dump") + " --database " + server);

  EXPECT_EQ(backup.code, 0) << backup.err;
  EXPECT_NE(backup.out.find("1 run, 2 marks"), std::string::npos) << backup.out;
  EXPECT_EQ(run("db verify " + file("backup.dump")).code, 0);
  const std::string whole = readFile(file("backup.dump"));
  writeFileAtomically(file("half.dump"), whole.substr(0, whole.size() / 2));
  EXPECT_EQ(run("db verify " + file("half.dump")).code, kVerifyFailed);

  Locator target = parseLocator(address);
  const std::string schema = target.schema;
  target.schema.clear();
  const std::string psql = "'" + addressOf(target) + "'";
  ASSERT_EQ(std::system(
                ("psql -q -c 'DROP SCHEMA \"" + schema + "\" CASCADE' " + psql + " >/dev/null 2>&1").c_str()),
            0);
  ASSERT_NE(run("db check --database " + server).code, 0) << "there is nothing now";
  ASSERT_EQ(std::system(("pg_restore --dbname=" + psql + " " + file("backup.dump")).c_str()), 0);
  const ProgramRun check = run("db check --database " + server);
  EXPECT_EQ(check.code, 0) << check.err << check.out;
}

TEST_F(DbCommandTest, AFailedBackupOfAServerLeavesNothingBehind) {
  const ProgramRun backup =
      run("db backup --as-system " + file("x.dump") + " --database postgresql://torsio@127.0.0.1:1/none");
  EXPECT_EQ(backup.code, static_cast<int>(ErrorCode::kDatabase)) << backup.err;
  EXPECT_FALSE(fs::exists(file("x.dump")));
}

TEST_F(DbCommandTest, KeepsBackupsByTheRuleAndRemovesOnlyItsOwn) {
  const std::string words =
      "db backup --as-system --keep 1,0,0 --into " + file("backups") + " --database " + file("record.sqlite");
  const auto kept = [this] {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(file("backups"))) {
      names.insert(entry.path().filename().string());
    }
    return names;
  };
  ASSERT_EQ(run(words).code, 0);
  const std::set<std::string> first = kept();
  ASSERT_EQ(first.size(), 1U);
  const std::string foreign = "torsio-2020-01-01T000000Z.sqlite";
  fs::copy_file(file("record.sqlite"), fs::path(file("backups")) / foreign);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // names tell seconds

  const ProgramRun second = run(words);

  EXPECT_EQ(second.code, 0) << second.err;
  EXPECT_NE(second.out.find("removed, as --keep says: "), std::string::npos) << second.out;
  EXPECT_NE(second.out.find(*first.begin()), std::string::npos) << second.out;
  EXPECT_EQ(kept().size(), 2U);
  EXPECT_TRUE(kept().contains(foreign)) << "not a backup that the record knows";
  EXPECT_FALSE(kept().contains(*first.begin()));
  const ProgramRun verified = run("db verify " + file("backups"));
  EXPECT_EQ(verified.code, 0) << verified.err;
  EXPECT_EQ(verified.out.find(foreign), std::string::npos) << "the newest";
  EXPECT_EQ(run("db copies --database " + file("record.sqlite")).out.find(*first.begin()), std::string::npos);
  EXPECT_EQ(run("audit verify --database " + file("record.sqlite")).code, 0);
  EXPECT_EQ(
      run("db backup --as-system --keep 0,1 --into " + file("b") + " --database " + file("record.sqlite"))
          .code,
      static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_EQ(run("db backup --as-system --database " + file("record.sqlite")).code,
            static_cast<int>(ErrorCode::kUsage))
      << "where to?";
}

TEST_F(DbCommandTest, CopiesACentreThereAndBackAndRefusesAUsedTarget) {
  const std::string target = "'" + withoutPassword(locator()) + "'";

  const ProgramRun there = run("db copy --as-system " + file("record.sqlite") + " " + target);

  EXPECT_EQ(there.code, 0) << there.err;
  EXPECT_NE(there.out.find("Copied and compared"), std::string::npos) << there.out;
  ASSERT_EQ(run("db reopen --as-system --reason again --database " + file("record.sqlite")).code, 0);
  const ProgramRun again = run("db copy --as-system " + file("record.sqlite") + " " + target);
  EXPECT_EQ(again.code, static_cast<int>(ErrorCode::kBadData));
  EXPECT_NE(again.err.find("the target is not empty"), std::string::npos) << again.err;
  EXPECT_EQ(run("audit verify --database " + target).code, 0);
  const ProgramRun back = run("db copy --as-system " + target + " " + file("back.sqlite"));
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_NE(back.out.find("  person: "), std::string::npos) << back.out;
}

TEST_F(DbCommandTest, TheBackupOfAnotherCentreNeedsToBeMeantByTwoPeople) {
  {
    Connection other = openRecord(file("other.sqlite"), OpenMode::kCreate, {.softwareVersion = "test"});
    const FullRecord rows(other, "other", false);
  }
  ASSERT_EQ(
      run("db backup --as-system " + file("theirs.backup") + " --database " + file("other.sqlite")).code, 0);
  const std::string restore =
      "db restore --as-system " + file("theirs.backup") + " --database " + file("record.sqlite");

  const ProgramRun refused = run(restore);
  EXPECT_EQ(refused.code, static_cast<int>(ErrorCode::kUsage)) << refused.err;
  EXPECT_NE(refused.err.find("backup of another centre"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--other-centre"), std::string::npos) << refused.err;
  const ProgramRun alone = run(restore + " --other-centre");
  EXPECT_EQ(alone.code, static_cast<int>(ErrorCode::kPermission)) << alone.err;
  EXPECT_NE(alone.err.find("takes two people"), std::string::npos) << alone.err;
  Connection kept = openFile();
  EXPECT_EQ(numberFrom(kept, "SELECT count(*) FROM training_mark WHERE id = 'real mark'"), 1);
}

TEST_F(DbCommandTest, EveryFileThatIsPutAsideIsListed) {
  const std::string database = " --database " + file("record.sqlite");
  ASSERT_EQ(run("db backup --as-system " + file("b.backup") + database).code, 0);
  ASSERT_EQ(run("db restore --as-system " + file("b.backup") + database).code, 0);
  const std::string listed = run("db copies" + database).out;
  EXPECT_NE(listed.find("record.sqlite.before-restore-1,"), std::string::npos) << listed;

  // What killed restores and schema changes leave, and what is none of theirs.
  for (const char* stray : {"record.sqlite.before-restore-7", "record-before-restore-20261121T143000Z.sqlite",
                            "record.sqlite.schema-1.sqlite"}) {
    fs::copy_file(file("record.sqlite"), file(stray));
  }
  for (const char* other :
       {"record2.sqlite.before-restore-1", "record.sqlite.before-restore-7-wal", "notes.txt"}) {
    writeFileAtomically(file(other), "text");
  }
  const std::string all = run("db copies" + database).out;
  EXPECT_NE(all.find("record.sqlite.before-restore-7,"), std::string::npos) << all;
  EXPECT_NE(all.find("record-before-restore-20261121T143000Z.sqlite,"), std::string::npos) << all;
  EXPECT_NE(all.find("record.sqlite.schema-1.sqlite,"), std::string::npos) << all;
  EXPECT_EQ(all.find("record2"), std::string::npos) << all;
  EXPECT_EQ(all.find("-wal"), std::string::npos) << all;
  EXPECT_EQ(all.find("notes"), std::string::npos) << all;
}

TEST_F(DbCommandTest, AMovedRecordSaysWhereItWentUntilTheMoveIsTakenBack) {
  const std::string database = " --database " + file("record.sqlite");
  ASSERT_EQ(run("db copy --as-system " + file("record.sqlite") + " " + file("there.sqlite")).code, 0);

  const ProgramRun again = run("db copy --as-system " + file("record.sqlite") + " " + file("second.sqlite"));
  EXPECT_EQ(again.code, static_cast<int>(ErrorCode::kBadData)) << again.err;
  EXPECT_NE(again.err.find("there.sqlite"), std::string::npos) << again.err;
  EXPECT_EQ(run("db check" + database).code, 0);
  EXPECT_EQ(run("db reopen --as-system --reason back --database " + file("there.sqlite")).code,
            static_cast<int>(ErrorCode::kBadData))
      << "the copy is the living one";

  const ProgramRun back = run("db reopen --as-system --reason 'a rehearsal'" + database);
  EXPECT_EQ(back.code, 0) << back.err;
  Connection record = openFile();
  EXPECT_EQ(numberFrom(record,
                       "SELECT count(*) FROM audit_entry WHERE action = 'database.move_given_up'"
                       " AND reason = 'a rehearsal'"),
            1);
  EXPECT_EQ(run("db copy --as-system " + file("record.sqlite") + " " + file("second.sqlite")).code, 0);
}

TEST_F(DbCommandTest, AMoveThatWasKilledAfterCopyingIsFinishedByTheNextTry) {
  const std::string copy = "db copy --as-system " + file("record.sqlite") + " " + file("there.sqlite");
  ASSERT_EQ(run(copy).code, 0);
  {
    Connection record = openFile();
    const std::string hash =
        selectFirst(record, "SELECT entry_hash FROM audit_entry WHERE sequence = 1", {}, readText)
            .value_or("");
    SettingRepository(record).set("record.moved_to", "", 1);
    SettingRepository(record).set("record.moving_to", "1 " + hash + " " + file("there.sqlite"), 1);
  }

  const ProgramRun next = run(copy);

  EXPECT_EQ(next.code, 0) << next.err;
  EXPECT_NE(next.out.find("was finished"), std::string::npos) << next.out;
  EXPECT_EQ(run("db check --database " + file("record.sqlite")).code, 0);
}

TEST_F(DbCommandTest, AClockThatWasSetIsNotedAndTheTrailIsWhole) {
  {
    Connection record = openFile();
    const std::int64_t day_us = 86'400'000'000;
    for (const std::int64_t days : {20'600, 18'300, 47'200}) {  // 2026, 2020, 2099
      AuditRepository(record).append({.atUtc_us = days * day_us,
                                      .actor = "admin",
                                      .station = "office",
                                      .action = AuditAction::kPersonChange,
                                      .objectKind = AuditObject::kPerson,
                                      .objectId = "p"});
    }
  }
  const std::string database = " --database " + file("record.sqlite");

  const ProgramRun verified = run("audit verify" + database);
  EXPECT_EQ(verified.code, 0) << verified.err;
  EXPECT_NE(verified.out.find("Note: the clock went back: entry "), std::string::npos) << verified.out;
  EXPECT_NE(verified.out.find("2020-02-08"), std::string::npos) << verified.out;
  EXPECT_NE(verified.out.find("dated 2099-"), std::string::npos) << verified.out;
  EXPECT_NE(run("audit verify --json" + database).out.find("\"clock\""), std::string::npos);
  EXPECT_NE(run("db check" + database).out.find("Note: the clock went back"), std::string::npos);
}

TEST_F(DbCommandTest, ReportsThatAnotherProgramHasTheFileOpen) {
  ASSERT_EQ(
      run("db backup --as-system " + file("backup.sqlite") + " --database " + file("record.sqlite")).code, 0);
  Connection other = openFile();
  Transaction writing(other);

  const ProgramRun restore =
      run("db restore --as-system " + file("backup.sqlite") + " --database " + file("record.sqlite"));

  EXPECT_EQ(restore.code, static_cast<int>(ErrorCode::kDatabase));
  EXPECT_NE(restore.err.find("is open in another program"), std::string::npos) << restore.err;
}

}  // namespace
}  // namespace torsio
