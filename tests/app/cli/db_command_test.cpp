// SPDX-License-Identifier: GPL-3.0-or-later
// torsio db and torsio audit through the real program, on a database with rows in every table.
#include <cstdlib>

#include <gtest/gtest.h>

#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/migrations.h"
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

TEST_F(DbCommandTest, RefersToServerToolsForPostgresql) {
  const ProgramRun backup =
      run("db backup --as-system x.dump --database postgresql://torsio@127.0.0.1:1/none");
  EXPECT_EQ(backup.code, static_cast<int>(ErrorCode::kUsage));
  EXPECT_NE(backup.err.find("pg_dump"), std::string::npos) << backup.err;
}

TEST_F(DbCommandTest, CopiesACentreThereAndBackAndRefusesAUsedTarget) {
  const std::string target = "'" + withoutPassword(locator()) + "'";

  const ProgramRun there = run("db copy --as-system " + file("record.sqlite") + " " + target);

  EXPECT_EQ(there.code, 0) << there.err;
  EXPECT_NE(there.out.find("Copied and compared"), std::string::npos) << there.out;
  const ProgramRun again = run("db copy --as-system " + file("record.sqlite") + " " + target);
  EXPECT_EQ(again.code, static_cast<int>(ErrorCode::kBadData));
  EXPECT_NE(again.err.find("the target is not empty"), std::string::npos) << again.err;
  EXPECT_EQ(run("audit verify --database " + target).code, 0);
  const ProgramRun back = run("db copy --as-system " + target + " " + file("back.sqlite"));
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_NE(back.out.find("  person: "), std::string::npos) << back.out;
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
