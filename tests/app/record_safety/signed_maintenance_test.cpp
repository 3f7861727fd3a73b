// SPDX-License-Identifier: GPL-3.0-or-later
// Maintenance from the command line requires a named person and is audited. Personal data are readable only
// by the record's owner, and erased data do not remain on the disk.

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "app/connectors/built_in.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/maintenance/retention.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/people/person_data.h"
#include "db/repository/people/second_factor_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"
#include "tests/app/record_safety/killed_program.h"
#include "tests/db/sample_record.h"
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
  [[nodiscard]] std::int64_t numberFromRecord(const std::string& sql) const {
    Connection connection = open();
    return numberFrom(connection, sql);
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

TEST_F(SignedMaintenance, ACommandAsksForTheCodeOfASecondFactor) {
  const std::string secret = newCodeSecret();
  {
    Connection connection = open();
    SecondFactorRepository(connection)
        .add("u-office", sealedCodeSecret(secret, kPassword, "u-office", PasswordCost::kTest), 0,
             std::vector<std::string>{"abcd-efgh-jkmn-pqrs"}, utcNow_us());
  }
  const auto withCode = [&](const std::string& name, const std::string& code) {
    std::ofstream(file(name)) << kPassword << "\n" << code << "\n";
    return run("db backup " + file(name + ".sqlite") + as("office", name));
  };

  const ProgramRun without = run("db backup " + file("b.sqlite") + as("office"));
  EXPECT_NE(without.code, 0);
  EXPECT_NE(without.err.find("code"), std::string::npos) << without.err;
  EXPECT_EQ(withCode("false", "000000").code, kPermission);
  EXPECT_EQ(withCode("right", oneTimeCode(secret, codeStepAt(utcNow_us()))).code, 0);
  EXPECT_EQ(withCode("recovery", "abcd-efgh-jkmn-pqrs").code, 0);
  EXPECT_EQ(withCode("again", "abcd-efgh-jkmn-pqrs").code, kPermission);
  EXPECT_FALSE(fs::exists(file("b.sqlite")));
  {
    Connection connection = open();
    SettingRepository(connection).set("second_factor", "administrators", utcNow_us());
  }
  const ProgramRun unready = run("db backup " + file("c.sqlite") + as("second"));
  EXPECT_EQ(unready.code, kPermission);
  EXPECT_NE(unready.err.find("set it up"), std::string::npos) << unready.err;
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

  for (const char* descriptor : {"9", "0", "65000", "-1", "abc", "3 3<."}) {
    EXPECT_EQ(run(backup + descriptor).code, kUsage) << descriptor;
  }
  EXPECT_EQ(run(backup + "3 3>" + file("sink")).code, kUsage) << "it can only be written to";
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

TEST_F(SignedMaintenance, AnotherCentresBackupNeedsTwoPeopleEvenWhereTheRuleIsOff) {
  {
    Connection connection = open();
    SettingRepository(connection).set("two_people", "no", 1);
    Connection other = openRecord(file("other.sqlite"), OpenMode::kCreate, {.softwareVersion = "test"});
    const FullRecord rows(other, "other", false);
  }
  ASSERT_EQ(
      runTorsio("db backup --as-system " + file("theirs.backup") + " --database " + file("other.sqlite"),
                folder_)
          .code,
      0);
  const std::string restore = "db restore --other-centre " + file("theirs.backup");

  EXPECT_EQ(run(restore + " --as-system").code, kPermission);
  EXPECT_EQ(run(restore + as("office")).code, kPermission);
  EXPECT_EQ(numberFromRecord("SELECT count(*) FROM centre WHERE id = 'other id'"), 0);
  const ProgramRun both = run(restore + " --as office --with second --password-fd 3 --with-password-fd 4 3<" +
                              file("password") + " 4<" + file("password"));

  EXPECT_EQ(both.code, 0) << both.err;
  EXPECT_EQ(numberFromRecord("SELECT count(*) FROM centre WHERE id = 'other id'"), 1);
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

  const auto requests = numberFromRecord("SELECT count(*) FROM duty_request");
  const ProgramRun alone = run("db restore " + file("b.sqlite") + as("office"));
  EXPECT_EQ(alone.code, kPermission);
  EXPECT_NE(alone.err.find("two people"), std::string::npos) << alone.err;
  const std::string with = " --with-password-fd 4 4<" + file("password") + " --with ";
  EXPECT_EQ(run("db restore " + file("b.sqlite") + as("office") + with + "office").code, kPermission);
  EXPECT_EQ(numberFromRecord("SELECT count(*) FROM duty_request"), requests) << "nothing was asked for";
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

namespace fs = std::filesystem;

constexpr auto kOthers = fs::perms::group_all | fs::perms::others_all;

bool isPrivate(const fs::path& file) {
  return (fs::status(file).permissions() & kOthers) == fs::perms::none;
}

TEST(PrivateFiles, WrittenFilesAreReadableOnlyByTheirOwner) {
  const fs::path folder = emptyFolder("private");
  const std::string out = (folder / "out").string();

  ASSERT_EQ(runTorsio("demo --shorten 600 --out " + out, folder).code, 0);
  ASSERT_EQ(
      runTorsio("db backup --as-system " + out + "/copy.sqlite --database " + out + "/torsio.sqlite", folder)
          .code,
      0);
  ASSERT_EQ(
      runTorsio("db restore --as-system " + out + "/copy.sqlite --database " + out + "/torsio.sqlite", folder)
          .code,
      0);

  EXPECT_TRUE(isPrivate(out));
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(out)) {
    EXPECT_TRUE(isPrivate(entry.path())) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 5U) << "record, backup, record before the restore, report and table";
}

TEST(PrivateFiles, ExportsAreReadableOnlyByTheirOwnerWhateverTheUmask) {
  const fs::path folder = emptyFolder("taken-out");
  const std::string record = (folder / "record.sqlite").string();
  {
    Connection connection = openRecord(record, OpenMode::kCreate, {.softwareVersion = "test"});
    const FullRecord rows(connection, "real", false);
  }
  const auto in = [&folder](const char* name) { return (folder / name).string(); };
  const std::string database = " --database " + record;
  const mode_t before = umask(0);
  for (const std::string& line :
       {"export workbook --out " + in("book.xlsx") + database,
        "export tables --as spss --out " + in("tables") + database,
        "dataset export --title T --licence CC-BY-4.0 --pseudonymised --key-file " + in("names.key") +
            " --out " + in("set") + database,
        "audit key " + in("key"), "audit head --key " + in("key") + " --witness " + in("heads") + database,
        "db copy --as-system " + record + " " + in("moved.sqlite"),
        "record --duration 1 --database " + in("new.sqlite")}) {
    EXPECT_EQ(runTorsio(line, folder).code, 0) << line;
  }
  umask(before);

  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    EXPECT_TRUE(isPrivate(entry.path())) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 25U);
}

TEST(PrivateFiles, ACrashLeavesNoDump) {
  const fs::path folder = emptyFolder("shown");
  rlimit before{};
  getrlimit(RLIMIT_CORE, &before);
  rlimit all = before;
  all.rlim_cur = all.rlim_max;
  setrlimit(RLIMIT_CORE, &all);
  const pid_t program = startSilent({"demo", "--shorten", "60", "--out", (folder / "out").string()});
  setrlimit(RLIMIT_CORE, &before);
  ASSERT_GT(program, 0);
  const std::string shown = "/proc/" + std::to_string(program);
  const auto limits = [&shown] {
    std::ifstream in(shown + "/limits");
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("Max core file size")) {
        return line;
      }
    }
    return std::string();
  };
  std::istringstream words;
  for (int tries = 0; tries < 6'000 && !fs::exists(folder / "out"); ++tries) {  // it has started working
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  words.str(limits().substr(18));
  std::string soft;
  std::string hard;
  words >> soft >> hard;
  kill(program, SIGSEGV);
  int status = 0;
  waitpid(program, &status, 0);

  EXPECT_EQ(soft, "0");
  EXPECT_EQ(hard, "0");
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(WCOREDUMP(status));
}

TEST(PrivateFiles, RecordsReadableByOthersAreClosedAndReported) {
  const fs::path folder = emptyFolder("mended");
  for (const char* name : {"torsio.sqlite", "torsio.sqlite.schema-1.sqlite", "torsio-before-restore-1.sqlite",
                           "somebody-else.txt"}) {
    std::ofstream(folder / name) << "x";
    fs::permissions(folder / name, fs::perms::owner_all | fs::perms::group_read | fs::perms::others_read);
  }
  fs::create_directories(folder / "unstored");
  fs::permissions(folder / "unstored", fs::perms::all);

  const std::vector<Text> told = closeRecordFiles((folder / "torsio.sqlite").string(), folder / "unstored");

  EXPECT_EQ(told.size(), 4U);
  EXPECT_TRUE(isPrivate(folder / "torsio.sqlite"));
  EXPECT_TRUE(isPrivate(folder / "unstored"));
  EXPECT_FALSE(isPrivate(folder / "somebody-else.txt"));
  EXPECT_TRUE(closeRecordFiles((folder / "torsio.sqlite").string(), folder / "unstored").empty());
}

TEST(PrivateFiles, AMaintenanceCommandClosesARecordAndCopiesReadableByOthers) {
  const fs::path folder = emptyFolder("closed");
  const std::string record = (folder / "record.sqlite").string();
  const std::string database = " --database " + record;
  ASSERT_EQ(runTorsio("record --duration 1" + database, folder).code, 0);
  ASSERT_EQ(runTorsio("db backup --as-system " + (folder / "first.backup").string() + database, folder).code,
            0);
  const auto open = [](const fs::path& file) {
    fs::permissions(file, fs::perms::group_read | fs::perms::others_read, fs::perm_options::add);
  };
  open(record);
  open(folder / "first.backup");

  EXPECT_EQ(runTorsio("db check" + database, folder).code, 0);
  EXPECT_FALSE(isPrivate(record)) << "a check leaves the file as it is";
  const ProgramRun backup =
      runTorsio("db backup --as-system " + (folder / "second.backup").string() + database, folder);

  EXPECT_EQ(backup.code, 0) << backup.err;
  EXPECT_TRUE(isPrivate(record));
  EXPECT_TRUE(isPrivate(folder / "first.backup"));
  for (const char* name : {"record.sqlite", "first.backup"}) {
    EXPECT_NE(backup.err.find("could read " + (folder / name).string() + ";"), std::string::npos)
        << backup.err;
  }
  open(record);
  const ProgramRun again = runTorsio("record --duration 1" + database, folder);
  EXPECT_TRUE(isPrivate(record));
  EXPECT_NE(again.err.find("now only yours can"), std::string::npos) << again.err;
}

TEST(PrivateFiles, TorsiosOwnFolderIsClosedAndAChosenOneIsNot) {
  const fs::path home = emptyFolder("own-folder");
  const fs::path own = home / "torsio/torsio";  // as in the window
  fs::create_directories(own);
  fs::permissions(own, fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
  const std::string database = " --database " + (own / "torsio.sqlite").string();
  const auto record = [&](const std::string& data) {
    return runTorsio("record --duration 1" + database, home, "XDG_DATA_HOME=" + data).code;
  };

  EXPECT_EQ(record((home / "elsewhere").string()), 0);
  EXPECT_FALSE(isPrivate(own));
  EXPECT_EQ(record(home.string()), 0);
  EXPECT_TRUE(isPrivate(own));
}

/// An administrator of a record with real and simulated rows in every table.
class ErasedBytes : public ::testing::Test {
 protected:
  ErasedBytes()
      : file_(emptyFolder("erased") / "record.sqlite"),
        connection_(openRecord(file_.string(), OpenMode::kCreate, {.softwareVersion = "test"})),
        real_(connection_, "real", false),
        simulated_(connection_, "demo", true) {
    connection_.execute(
        "INSERT INTO app_user (id, login, password_hash, must_change_password, state, failed_count,"
        " locked_until_utc_us, created_utc_us, demonstration) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
        {"u", "admin", "", false, "active", 0, 0, kSampleTime_us, false});
    connection_.execute("INSERT INTO user_role (user_id, role_code) VALUES (?, ?)", {"u", "administrator"});
    SettingRepository(connection_).set("two_people", "no", kSampleTime_us);  // one administrator may do
                                                                             // everything
  }
  SessionContext office() {
    Actor actor{.userId = "u", .login = "admin"};
    actor.roles = {"administrator"};
    return {connection_, ids_, {file_.string(), "room", actor}, [] { return kSampleTime_us; }};
  }
  /// Returns whether the bytes occur anywhere in the file or its log.
  [[nodiscard]] bool found(const std::string& text) const {
    const fs::path log = file_.string() + "-wal";
    return readFile(file_).find(text) != std::string::npos ||
           (fs::exists(log) && readFile(log).find(text) != std::string::npos);
  }

  fs::path file_;
  Connection connection_;
  SeededIdSource ids_{7};
  FullRecord real_;
  FullRecord simulated_;
};

TEST_F(ErasedBytes, TheNameOfAnErasedPersonIsNotInTheFileOrItsLog) {
  const std::string name = "Nobody Likely Uvwxyz";
  connection_.execute(
      "INSERT INTO person_identity (person_id, full_name) VALUES (?, ?)"
      " ON CONFLICT (person_id) DO UPDATE SET full_name = excluded.full_name",
      {real_.traineeId, name});
  ASSERT_TRUE(found(name));
  SessionContext session = office();

  erasePersonRecord(session, real_.traineeId, "asked for it");

  EXPECT_FALSE(found(name));
}

TEST_F(ErasedBytes, RemovingTheDemonstrationFreesItsSpace) {
  SessionContext session = office();

  removeDemonstrationData(session, "the centre begins");

  EXPECT_EQ(numberFrom(connection_, "PRAGMA freelist_count"), 0);
  const fs::path log = file_.string() + "-wal";
  EXPECT_TRUE(!fs::exists(log) || fs::file_size(log) == 0);
}

}  // namespace

}  // namespace torsio
