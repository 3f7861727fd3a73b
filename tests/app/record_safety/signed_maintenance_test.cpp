// SPDX-License-Identifier: GPL-3.0-or-later
// Maintenance from the command line requires a named person and is audited.
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "app/connectors/built_in.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "tests/app/cli/program.h"
#include "tests/app/record_safety/killed_program.h"
#include "tests/db/full_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPassword = "four walls and a lamp";
constexpr int kPermission = static_cast<int>(ErrorCode::kPermission);

/// A record with two administrators, "office" and "second", and a rater.
class SignedMaintenance : public ::testing::Test {
 protected:
  SignedMaintenance()
      : folder_(emptyFolder(std::string("signed-") +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    Connection connection = open();
    const FullRecord rows(connection, "real", false);
    person_ = rows.traineeId;
    AccessRepository access(connection, PasswordCost::kTest);
    for (const auto& [login, role] : {std::pair<std::string, std::string>{"office", "administrator"},
                                      {"second", "administrator"},
                                      {"rater", "rater"}}) {
      access.addUser({.id = "u-" + login, .login = login, .roles = {role}}, kPassword);
      access.setPassword("u-" + login, access.sealPassword(login, kPassword), false);
    }
    std::ofstream(file("password")) << kPassword << "\n";
    std::ofstream(file("wrong")) << "something else entirely\n";
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] Connection open() const {
    return openRecord(file("record.sqlite"), OpenMode::kCreate, {.softwareVersion = "test"});
  }
  [[nodiscard]] ProgramRun run(const std::string& arguments) const {
    return runTorsio(arguments + " --database " + file("record.sqlite"), folder_);
  }
  /// Runs the program on a machine whose clock is ahead.
  [[nodiscard]] ProgramRun runAhead(long seconds, const std::string& arguments) const {
    return runTorsio(arguments + " --database " + file("record.sqlite"), folder_,
                     "LD_PRELOAD=" TORSIO_FAULT_POINTS " TORSIO_FAULT_CLOCK_S=" + std::to_string(seconds));
  }
  [[nodiscard]] std::string as(const std::string& login, const std::string& password = "password") const {
    return " --as " + login + " --password-fd 3 3<" + file(password);
  }
  [[nodiscard]] std::string newestActorOf(const std::string& action) const {
    Connection connection = open();
    Statement row =
        connection.prepare("SELECT actor FROM audit_entry WHERE action = ? ORDER BY sequence DESC LIMIT 1");
    row.execute({action});
    return row.step() ? row.text(0) : "";
  }

  fs::path folder_;
  PersonId person_;
};

TEST_F(SignedMaintenance, ABackupRequiresAName) {
  const std::string backup = "db backup " + file("b.sqlite");

  const ProgramRun unnamed = run(backup);
  EXPECT_EQ(unnamed.code, kPermission);
  EXPECT_NE(unnamed.err.find("--as-system"), std::string::npos) << unnamed.err;
  EXPECT_EQ(run(backup + as("office", "wrong")).code, kPermission);
  EXPECT_EQ(run(backup + as("nobody")).code, kPermission);
  EXPECT_EQ(run(backup + as("rater")).code, kPermission);
  EXPECT_FALSE(fs::exists(file("b.sqlite")));

  const ProgramRun done = run(backup + as("office"));
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(newestActorOf("database.backup"), "u-office");
  EXPECT_EQ(newestActorOf("user.sign_in_failed"), "torsio");
  EXPECT_EQ(run("db backup --as-system " + file("c.sqlite")).code, 0);
  EXPECT_EQ(newestActorOf("database.backup"), "system:" + std::to_string(geteuid()));
}

TEST_F(SignedMaintenance, AnUnreadableOrWrongPasswordOpensNothing) {
  std::ofstream(file("empty")).close();
  std::ofstream(file("blank")) << "\n" << kPassword << "\n";
  std::ofstream(file("longer")) << kPassword << " \n";
  std::ofstream(file("nul")) << kPassword << '\0' << "\n";
  std::ofstream(file("endless")) << std::string(100'000, 'a');
  std::ofstream(file("windows")) << kPassword << "\r\n";
  const std::string backup = "db backup " + file("b.sqlite") + " --as office --password-fd ";
  constexpr int kUsage = static_cast<int>(ErrorCode::kUsage);

  for (const char* descriptor : {"9", "0", "65000", "-1", "abc", "3 3<.", "3 3>sink"}) {
    EXPECT_EQ(run(backup + descriptor).code, kUsage) << descriptor;
  }
  for (const char* name : {"empty", "blank"}) {
    EXPECT_EQ(run(backup + "3 3<" + file(name)).code, kUsage) << name;
  }
  for (const char* name : {"longer", "nul", "endless"}) {
    EXPECT_EQ(run(backup + "3 3<" + file(name)).code, kPermission) << name;
  }
  EXPECT_EQ(run("db backup " + file("b.sqlite") + " --as ''").code, kPermission) << "nobody is nobody";
  EXPECT_FALSE(fs::exists(file("b.sqlite")));
  EXPECT_EQ(runAhead(61, backup + "3 3<" + file("windows")).code, 0)
      << "the end of a line is no part of a password";
}

TEST_F(SignedMaintenance, AClockThatRan400DaysAheadLocksNobodyOutAndLosesNothing) {
  constexpr long kAhead_s = 400L * 86'400;
  const std::string head = "audit head --key " + file("key") + " --witness " + file("heads");
  ASSERT_EQ(runTorsio("audit key " + file("key"), folder_).code, 0);
  for (int failure = 0; failure < 5; ++failure) {
    EXPECT_EQ(runAhead(kAhead_s, "db backup " + file("b.sqlite") + as("office", "wrong")).code, kPermission);
  }
  ASSERT_EQ(runAhead(kAhead_s, "db backup --as-system " + file("later.sqlite")).code, 0);
  ASSERT_EQ(runAhead(kAhead_s, head).code, 0);

  const std::string backup = "db backup --replace " + file("now.sqlite") + as("office");
  EXPECT_EQ(run(backup).code, kPermission) << "the wait begins anew";
  EXPECT_EQ(runAhead(61, backup).code, 0) << "and is a minute at most";
  EXPECT_EQ(run(head).code, 0);
  EXPECT_EQ(run("audit verify --key " + file("key") + " --witness " + file("heads")).code, 0);
  EXPECT_EQ(run("db check").code, 0);
  EXPECT_NE(run("db copies").out.find(file("later.sqlite")), std::string::npos);
}

TEST_F(SignedMaintenance, ReadingRequiresNobody) {
  EXPECT_EQ(run("db check").code, 0);
  EXPECT_EQ(run("audit verify").code, 0);
  EXPECT_EQ(run("audit head").code, 0);
}

TEST_F(SignedMaintenance, ARestoreRepeatsLaterErasuresAndIsAudited) {
  {
    Connection connection = open();
    SettingRepository(connection).set("two_people", "no", 1);
  }
  ASSERT_EQ(run("db backup " + file("b.sqlite") + as("office")).code, 0);
  {
    Connection connection = open();
    erasePerson(connection, person_, "u-office", "asked", 5);
  }

  const ProgramRun restored = run("db restore " + file("b.sqlite") + as("office"));

  EXPECT_EQ(restored.code, 0) << restored.err;
  EXPECT_NE(restored.out.find("erased again: 1 person"), std::string::npos) << restored.out;
  EXPECT_EQ(newestActorOf("database.restore"), "u-office");
  Connection connection = open();
  EXPECT_EQ(numberFrom(connection,
                       "SELECT count(*) FROM person_identity WHERE person_id = '" + person_.text() + "'"),
            0);
  EXPECT_EQ(run("audit verify").code, 0);
}

TEST_F(SignedMaintenance, ARestoredRecordKnowsLaterCopies) {
  ASSERT_EQ(run("db backup --as-system " + file("first.backup")).code, 0);
  ASSERT_EQ(run("db backup --as-system " + file("second.backup")).code, 0);

  ASSERT_EQ(run("db restore --as-system " + file("first.backup")).code, 0);

  const std::string listed = run("db copies").out;
  for (const char* name : {"first.backup", "second.backup", "record-before-restore-"}) {
    EXPECT_NE(listed.find(file(name)), std::string::npos) << name << " is not in\n" << listed;
  }
  EXPECT_EQ(run("audit verify").code, 0);
}

TEST_F(SignedMaintenance, ARestoreNeedsTwoPeopleIfTheCentreRequiresThem) {
  ASSERT_EQ(run("db backup " + file("b.sqlite") + as("office")).code, 0);

  const ProgramRun alone = run("db restore " + file("b.sqlite") + as("office"));
  EXPECT_EQ(alone.code, kPermission);
  EXPECT_NE(alone.err.find("two people"), std::string::npos) << alone.err;
  const std::string with = " --with-password-fd 4 4<" + file("password") + " --with ";
  EXPECT_EQ(run("db restore " + file("b.sqlite") + as("office") + with + "office").code, kPermission);
  EXPECT_EQ(run("db restore " + file("b.sqlite") + as("office") + with + "rater").code, kPermission);

  const ProgramRun both = run("db restore " + file("b.sqlite") + as("office") + with + "second");
  EXPECT_EQ(both.code, 0) << both.err;
  EXPECT_EQ(newestActorOf("database.restore"), "u-second");
  Connection restored = open();
  const std::string told =
      selectAll(restored, "SELECT new_json FROM audit_entry WHERE action = 'database.restore'", {}, readText)
          .at(0);
  EXPECT_NE(told.find(R"("asked_by":"u-office","confirmed_by":"u-second")"), std::string::npos) << told;
}

TEST_F(SignedMaintenance, ADamagedRecordIsRestoredBySigningInToTheBackup) {
  ASSERT_EQ(run("db backup " + file("b.sqlite") + as("office")).code, 0);
  for (const char* part : {"-wal", "-shm"}) {
    fs::remove(file("record.sqlite") + part);
  }
  fs::resize_file(file("record.sqlite"), 100);

  EXPECT_EQ(run("db restore " + file("b.sqlite") + as("office", "wrong")).code, kPermission);
  EXPECT_EQ(fs::file_size(file("record.sqlite")), 100U);
  const ProgramRun restored = run("db restore --as-system " + file("b.sqlite"));

  EXPECT_EQ(restored.code, 0) << restored.err;
  EXPECT_NE(restored.err.find("cannot be read"), std::string::npos) << restored.err;
  EXPECT_EQ(newestActorOf("database.restore"), "system:" + std::to_string(geteuid()));
}

TEST_F(SignedMaintenance, TheSystemMaintainsOnlyWhatItOwns) {
  if (geteuid() != 0) {
    GTEST_SKIP() << "only root can give a file away";
  }
  ASSERT_EQ(chown(file("record.sqlite").c_str(), 65534, 65534), 0);

  const ProgramRun backup = run("db backup --as-system " + file("b.sqlite"));

  EXPECT_EQ(backup.code, kPermission);
  EXPECT_NE(backup.err.find("belongs to another account"), std::string::npos) << backup.err;
  EXPECT_EQ(run("db backup " + file("b.sqlite") + as("office")).code, 0);
}

TEST_F(SignedMaintenance, ThePasswordIsInNoListOfProcesses) {
  // The program waits for the rest of the password, so that it can be inspected.
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const std::string half = "half-of-a-secret";
  ASSERT_EQ(write(pipe[1], half.data(), half.size()), static_cast<ssize_t>(half.size()));
  const pid_t program = startSilent({"db", "backup", file("b.sqlite"), "--as", "office", "--password-fd",
                                     std::to_string(pipe[0]), "--database", file("record.sqlite")});
  ASSERT_GT(program, 0);
  const std::string shown = "/proc/" + std::to_string(program);
  int waiting = 1;
  for (int tries = 0; tries < 6'000 && waiting > 0; ++tries) {  // until it has read what was sent
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ioctl(pipe[0], FIONREAD, &waiting);
  }
  std::string told;
  for (const char* what : {"/cmdline", "/environ"}) {
    std::ifstream in(shown + what, std::ios::binary);
    told.append(std::istreambuf_iterator<char>(in), {});
  }
  EXPECT_EQ(waiting, 0);
  EXPECT_NE(told.find("--password-fd"), std::string::npos);
  EXPECT_EQ(told.find(half), std::string::npos);
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  close(pipe[0]);
  close(pipe[1]);
}

TEST_F(SignedMaintenance, APasswordInAnAddressIsRejectedAndNotRepeated) {
  std::vector<std::string> commands{"db check --database",
                                    "audit verify --database",
                                    "db backup --as-system b.sqlite --database",
                                    "db copy --as-system record.sqlite",
                                    "db prepare-server --as-system",
                                    "metrics t --database",
                                    "competence show --login office --database",
                                    "export workbook --out b.xlsx --database",
                                    "dataset export --out d --title T --licence MIT --database",
                                    "report trace a --database",
                                    "--database"};
  if (kForeignBuiltIn) {
    commands.emplace_back("dataset import --as torsio --login office --database");
  }
  for (const std::string& command : commands) {
    const ProgramRun refused = runTorsio(command + " postgresql://torsio:hidden-word@127.0.0.1:1/none",
                                         folder_, "QT_QPA_PLATFORM=offscreen timeout 60");
    EXPECT_EQ(refused.code, static_cast<int>(ErrorCode::kUsage)) << command;
    EXPECT_NE(refused.err.find(".pgpass"), std::string::npos) << refused.err;
    EXPECT_EQ(refused.err.find("hidden-word"), std::string::npos) << refused.err;
  }
}

}  // namespace
}  // namespace torsio
