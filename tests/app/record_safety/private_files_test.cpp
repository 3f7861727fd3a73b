// SPDX-License-Identifier: GPL-3.0-or-later
// Personal data are readable only by the record's owner, and erased data do not remain on the disk.
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>

#include <gtest/gtest.h>

#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/maintenance/retention.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"
#include "tests/app/record_safety/killed_program.h"
#include "tests/db/full_record.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

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
  const fs::path own = home / "torsio";
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
