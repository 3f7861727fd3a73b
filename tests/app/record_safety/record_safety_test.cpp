// SPDX-License-Identifier: GPL-3.0-or-later
// Torsio never destroys a record, whatever the command line is told to write and whenever a program is
// killed.
#include <algorithm>
#include <fstream>
#include <functional>
#include <random>
#include <sys/stat.h>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/first_run.h"
#include "db/connection/connection.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "tests/app/cli/program.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShort = " --shorten 600 --seed 7";

int codeOf(ErrorCode code) {
  return static_cast<int>(code);
}

/// A folder with a real centre's record under the default name, and a backup of it.
class RecordSafety : public ::testing::Test {
 protected:
  RecordSafety()
      : folder_(emptyFolder(std::string("safety-") +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name())) {}

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] ProgramRun run(const std::string& arguments) const { return runTorsio(arguments, folder_); }
  void makeRecord(const std::string& name, const std::string& prefix = "real") const {
    Connection connection = openRecord(file(name), OpenMode::kCreate, {.softwareVersion = "test"});
    const FullRecord rows(connection, prefix, false);
    SettingRepository(connection).set("two_people", "no", kSampleTime_us);
    connection.execute("UPDATE app_user SET state = ?",
                       {"disabled"});  // the owner of the file alone may do all
  }
  [[nodiscard]] std::string personIn(const std::string& name, OpenMode mode = OpenMode::kReadOnly) const {
    Connection connection = openRecord(file(name), mode);
    Statement row = connection.prepare("SELECT min(id) FROM person");
    row.execute();
    return row.step() ? row.text(0) : "";
  }
  /// Returns files in the folder whose names begin with `name`.
  [[nodiscard]] std::vector<std::string> besides(const std::string& name) const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string other = entry.path().filename().string();
      if (other != name && other.starts_with(name)) {
        found.push_back(other);
      }
    }
    return found;
  }

  /// Copies "sound.sqlite" with other bytes at one position.
  void overwritten(const std::string& path, const std::string& bytes, std::streamoff at = 0) const {
    fs::copy_file(file("sound.sqlite"), path);
    std::fstream copy(path, std::ios::in | std::ios::out | std::ios::binary);
    copy.seekp(at);
    copy << bytes;
  }
  /// Returns bytes like those of a compressed picture.
  static std::string noise(std::size_t length) {
    std::mt19937 random(1);
    std::string bytes(length, '\0');
    std::generate(bytes.begin(), bytes.end(), [&random] { return static_cast<char>(random()); });
    return bytes;
  }

  fs::path folder_;
};

TEST_F(RecordSafety, ADemonstrationDoesNotReplaceARecordWithARealPerson) {
  makeRecord("torsio.sqlite");
  const std::string before = readFile(file("torsio.sqlite"));

  const ProgramRun demo = run("demo --out " + folder_.string() + kShort);

  EXPECT_EQ(demo.code, codeOf(ErrorCode::kFileUnwritable)) << demo.err;
  EXPECT_EQ(readFile(file("torsio.sqlite")), before);
  EXPECT_FALSE(fs::exists(file("cohort.pdf")));
}

TEST_F(RecordSafety, ADemonstrationDoesNotReplaceAnUnreadableFile) {
  for (const std::string content : {"", "no database", "SQLite format 3 and then nothing of the kind"}) {
    std::ofstream(file("torsio.sqlite"), std::ios::trunc) << content;

    const ProgramRun demo = run("demo --out " + folder_.string() + kShort);

    EXPECT_EQ(demo.code, codeOf(ErrorCode::kFileUnwritable)) << demo.err;
    EXPECT_EQ(readFile(file("torsio.sqlite")), content);
  }
}

TEST_F(RecordSafety, ADemonstrationReplacesAnOlderOneThatNobodyHasOpen) {
  ASSERT_EQ(run("demo --out " + folder_.string() + kShort).code, 0);
  {
    Connection open = openRecord(file("torsio.sqlite"), OpenMode::kReadWrite);
    const Transaction working(open);
    EXPECT_EQ(run("demo --out " + folder_.string() + kShort).code, codeOf(ErrorCode::kDatabase));
  }

  const ProgramRun again = run("demo --out " + folder_.string() + kShort + "1");

  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(run("audit verify --database " + file("torsio.sqlite")).code, 0);
  EXPECT_TRUE(besides("torsio.sqlite").empty());
}

TEST_F(RecordSafety, EveryRestoreKeepsThePreviousRecord) {
  makeRecord("record.sqlite", "original");
  makeRecord("a.sqlite", "a");
  makeRecord("b.sqlite", "b");
  for (const std::string name : {"a", "b"}) {
    ASSERT_EQ(
        run("db backup --as-system " + file(name + ".backup") + " --database " + file(name + ".sqlite")).code,
        0);
  }

  const ProgramRun first = run("db restore --as-system --other-centre " + file("a.backup") + " --database " +
                               file("record.sqlite"));
  const ProgramRun second = run("db restore --as-system --other-centre " + file("b.backup") + " --database " +
                                file("record.sqlite"));

  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(second.code, 0) << second.err;
  EXPECT_EQ(personIn("record.sqlite").substr(0, 1), "b");
  EXPECT_EQ(personIn("record.sqlite.before-restore-1").substr(0, 8), "original");
  EXPECT_EQ(personIn("record.sqlite.before-restore-2").substr(0, 1), "a");
  EXPECT_NE(second.out.find("before-restore-2"), std::string::npos) << second.out;
}

TEST_F(RecordSafety, ABackupReplacesAnOlderBackupOnRequestButNeverARecord) {
  makeRecord("record.sqlite");
  makeRecord("other.sqlite", "other");
  const std::string other = readFile(file("other.sqlite"));
  const std::string database = " --database " + file("record.sqlite");
  ASSERT_EQ(run("db backup --as-system " + file("backup.sqlite") + database).code, 0);

  EXPECT_EQ(run("db backup --as-system " + file("backup.sqlite") + database).code,
            codeOf(ErrorCode::kFileUnwritable));
  EXPECT_EQ(run("db backup --as-system --replace " + file("backup.sqlite") + database).code, 0);
  for (const char* record : {"other.sqlite", "record.sqlite"}) {
    EXPECT_EQ(run("db backup --as-system --replace " + file(record) + database).code,
              codeOf(ErrorCode::kFileUnwritable));
  }

  EXPECT_EQ(readFile(file("other.sqlite")), other);
  EXPECT_EQ(run("db check" + database).code, 0);
}

TEST_F(RecordSafety, ABackupReplacesNoFileOfAnotherKind) {
  makeRecord("record.sqlite");
  std::ofstream(file("thesis.txt")) << "two years of work";
  std::ofstream(file("empty.tmp"));

  const auto replace = [this](const char* name) {
    return run("db backup --as-system --replace " + file(name) + " --database " + file("record.sqlite")).code;
  };

  EXPECT_EQ(replace("thesis.txt"), codeOf(ErrorCode::kFileUnwritable));
  EXPECT_EQ(readFile(file("thesis.txt")), "two years of work");
  EXPECT_EQ(replace("empty.tmp"), 0) << "a name that mktemp made";
}

TEST_F(RecordSafety, ARestoredRecordIsNoLongerABackup) {
  makeRecord("record.sqlite");
  const std::string database = " --database " + file("record.sqlite");
  ASSERT_EQ(run("db backup --as-system " + file("backup.sqlite") + database).code, 0);
  ASSERT_EQ(run("db restore --as-system " + file("backup.sqlite") + " --database " + file("new.sqlite")).code,
            0);

  const ProgramRun backup = run("db backup --as-system --replace " + file("new.sqlite") + database);

  EXPECT_EQ(backup.code, codeOf(ErrorCode::kFileUnwritable));
}

TEST_F(RecordSafety, AnEmptyFileIsNoRecordAndIsNotBackedUp) {
  makeRecord("record.sqlite");
  fs::resize_file(file("record.sqlite"), 0);
  const std::string database = " --database " + file("record.sqlite");

  EXPECT_EQ(run("db backup --as-system " + file("backup.sqlite") + database).code,
            codeOf(ErrorCode::kFileUnreadable));
  EXPECT_EQ(run("db check" + database).code, codeOf(ErrorCode::kFileUnreadable));
  EXPECT_EQ(run("db verify " + file("record.sqlite")).code, codeOf(ErrorCode::kFileUnreadable));

  EXPECT_FALSE(fs::exists(file("backup.sqlite")));
  EXPECT_EQ(refusalFrom([&] { (void)lookAtRecord(file("record.sqlite")); }).code, ErrorCode::kFileUnreadable);
}

TEST_F(RecordSafety, AKnownRecordThatIsMissingOrEmptyIsAnError) {
  makeRecord("empty.sqlite");
  {
    Connection connection = openDatabase(file("schema.sqlite"), OpenMode::kCreate);
    migrate(connection, embeddedMigrations(), {});
  }

  EXPECT_EQ(refusalFrom([&] { requireKnownRecord(file("none.sqlite")); }).code, ErrorCode::kFileMissing);
  EXPECT_EQ(refusalFrom([&] { requireKnownRecord(file("schema.sqlite")); }).code, ErrorCode::kVerifyFailed);
  fs::resize_file(file("empty.sqlite"), 0);
  EXPECT_EQ(refusalFrom([&] { requireKnownRecord(file("empty.sqlite")); }).code, ErrorCode::kFileUnreadable);
}

TEST_F(RecordSafety, CheckingWhereARecordCouldBeWritesNothing) {
  EXPECT_EQ(lookAtRecord(file("new.sqlite")), RecordPlace::kNothing);
  EXPECT_EQ(refusalFrom([&] { (void)lookAtRecord(file("none/new.sqlite")); }).code,
            ErrorCode::kFileUnwritable);

  EXPECT_TRUE(fs::is_empty(folder_));
}

/// Content of a path where a record is expected, and its error code.
struct NoRecord {
  const char* what;
  std::function<void(const std::string& path)> make;
  ErrorCode code;
};

/// Leaves what a program killed in the middle of a change leaves before any page is written.
void leaveHalfDone(const std::string& record) {
  constexpr std::uintmax_t kPage_bytes = 4096;
  const std::uintmax_t pages = fs::file_size(record) / kPage_bytes;
  std::string journal("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7\0\0\0\0\0\0\0\0", 16);  // no page to roll back
  for (const int shift : {24, 16, 8, 0}) {
    journal += static_cast<char>(pages >> shift);
  }
  journal += std::string("\0\0\2\0\0\0\x10\0", 8);
  journal.resize(512, '\0');
  std::ofstream(record + "-journal", std::ios::binary) << journal;
}

TEST_F(RecordSafety, AChangeInterruptedByAKillIsRolledBackAtTheNextStart) {
  makeRecord("known.sqlite");
  {
    Connection connection = openDatabase(file("known.sqlite"), OpenMode::kReadWrite);
    connection.executeVerbatim("PRAGMA journal_mode = DELETE");
  }
  leaveHalfDone(file("known.sqlite"));

  EXPECT_EQ(lookAtRecord(file("known.sqlite")), RecordPlace::kCentre);

  EXPECT_FALSE(fs::exists(file("known.sqlite-journal")));
  EXPECT_EQ(runTorsio("db check --database " + file("known.sqlite"), folder_).code, 0);
}

TEST_F(RecordSafety, ChecksOfInvalidRecordsReportItAndChangeNothing) {
  makeRecord("sound.sqlite");
  {
    Connection connection = openDatabase(file("sound.sqlite"), OpenMode::kReadWrite);
    connection.executeVerbatim("PRAGMA journal_mode = DELETE");
  }
  const auto write = [](const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  };
  const auto changed = [this](const std::string& path, const std::string& sql) {
    fs::copy_file(file("sound.sqlite"), path);
    Connection connection = openDatabase(path, OpenMode::kReadWrite);
    connection.executeVerbatim(sql);
    connection.executeVerbatim("PRAGMA journal_mode = DELETE");
  };
  const std::string newer =
      "INSERT INTO schema_migration SELECT max(version) + 1, 'later', '', checksum, 99, software_version,"
      " applied_utc_us FROM schema_migration";
  const std::vector<NoRecord> all{
      {"nothing", [](const std::string&) {}, ErrorCode::kFileMissing},
      {"a pipe", [](const std::string& path) { mkfifo(path.c_str(), 0600); }, ErrorCode::kFileUnreadable},
      {"a folder", [](const std::string& path) { fs::create_directory(path); }, ErrorCode::kFileUnreadable},
      {"an empty file", [&](const std::string& path) { write(path, ""); }, ErrorCode::kFileUnreadable},
      {"a text", [&](const std::string& path) { write(path, std::string(9'000, 'x')); },
       ErrorCode::kFileUnreadable},
      {"a link to nothing", [](const std::string& path) { fs::create_symlink(path + ".gone", path); },
       ErrorCode::kFileMissing},
      {"the first half",
       [this](const std::string& path) {
         fs::copy_file(file("sound.sqlite"), path);
         fs::resize_file(path, fs::file_size(path) / 2);
       },
       ErrorCode::kVerifyFailed},
      {"the first 100 bytes",
       [this](const std::string& path) {
         fs::copy_file(file("sound.sqlite"), path);
         fs::resize_file(path, 100);
       },
       ErrorCode::kVerifyFailed},
      {"a record whose first 100 bytes are others",
       [this](const std::string& path) { overwritten(path, noise(100)); }, ErrorCode::kVerifyFailed},
      {"a record whose first page is another",
       [this](const std::string& path) { overwritten(path, noise(4096)); }, ErrorCode::kVerifyFailed},
      {"a record whose first letter is another", [this](const std::string& path) { overwritten(path, "T"); },
       ErrorCode::kVerifyFailed},
      {"a record of a format that there is not",
       [this](const std::string& path) { overwritten(path, "\xFB", 47); }, ErrorCode::kVerifyFailed},
      {"a picture", [&](const std::string& path) { write(path, "\xFF\xD8\xFF\xE0" + noise(100 * 4096 - 4)); },
       ErrorCode::kFileUnreadable},
      {"a database of another program",
       [](const std::string& path) {
         Connection other = openDatabase(path, OpenMode::kCreate);
         other.executeVerbatim("CREATE TABLE notes (text TEXT)");
         other.executeVerbatim("PRAGMA journal_mode = DELETE");
       },
       ErrorCode::kFileUnreadable},
      {"a record of a newer version", [&](const std::string& path) { changed(path, newer); },
       ErrorCode::kNewerSchema},
      {"a record with a change that a killed program left half done",
       [&](const std::string& path) {
         fs::copy_file(file("sound.sqlite"), path);
         leaveHalfDone(path);
       },
       ErrorCode::kFileUnreadable},
      {"a record whose step of the schema is another one",
       [&](const std::string& path) {
         changed(path, "UPDATE schema_migration SET checksum = checksum || 'x'");
       },
       ErrorCode::kVerifyFailed},
  };
  for (const NoRecord& one : all) {
    const std::string path = file("looked-at");
    fs::remove_all(path);
    one.make(path);
    const std::vector<std::string> before = besides("");
    for (const char* command : {"db check --database ", "audit verify --database ", "db verify "}) {
      const ProgramRun run = runTorsio(command + path, folder_, "timeout 20");
      EXPECT_EQ(run.code, codeOf(one.code)) << command << one.what << ": " << run.out << run.err;
      EXPECT_TRUE(run.err.starts_with("torsio: ")) << command << one.what << ": " << run.err;
      EXPECT_EQ(besides(""), before) << command << one.what;
    }
    fs::remove(path + "-journal");
  }
}

TEST_F(RecordSafety, LinksLeadToTheRecordAndHideNone) {
  fs::create_directories(folder_ / "disk");
  makeRecord("disk/record.sqlite");
  makeRecord("b.sqlite", "b");
  ASSERT_EQ(run("db backup --as-system " + file("b.backup") + " --database " + file("b.sqlite")).code, 0);
  fs::create_symlink(file("disk/record.sqlite"), file("link.sqlite"));
  const std::string database = " --database " + file("link.sqlite");

  EXPECT_EQ(run("db check" + database).code, 0);
  fs::create_symlink(file("disk/record.sqlite"), file("link.backup"));
  EXPECT_EQ(run("db backup --as-system --replace " + file("link.backup") + database).code,
            codeOf(ErrorCode::kFileUnwritable))
      << "the record itself, by another name";
  EXPECT_EQ(run("audit head --witness " + file("link.backup") + database).code,
            codeOf(ErrorCode::kFileUnwritable));
  ASSERT_EQ(run("db restore --as-system --other-centre " + file("b.backup") + database).code, 0);
  EXPECT_TRUE(fs::is_symlink(file("link.sqlite")));
  EXPECT_EQ(personIn("disk/record.sqlite").substr(0, 2), "b ");
  EXPECT_EQ(personIn("link.sqlite").substr(0, 2), "b ");

  fs::rename(file("disk"), file("unplugged"));
  EXPECT_EQ(refusalFrom([this] { (void)lookAtRecord(file("link.sqlite")); }).code, ErrorCode::kFileMissing)
      << "a first-run wizard in its place";
  EXPECT_EQ(run("record --duration 1" + database).code, codeOf(ErrorCode::kFileMissing));
  EXPECT_TRUE(fs::is_symlink(file("link.sqlite")));
}

TEST_F(RecordSafety, DamagedPagesAreAFailedCheck) {
  makeRecord("record.sqlite");
  ASSERT_EQ(
      run("db backup --as-system " + file("sound.sqlite") + " --database " + file("record.sqlite")).code, 0);

  for (const std::streamoff page : {std::streamoff{0}, std::streamoff{1}, std::streamoff{2}}) {
    fs::copy_file(file("sound.sqlite"), file("bad.sqlite"), fs::copy_options::overwrite_existing);
    std::fstream bad(file("bad.sqlite"), std::ios::in | std::ios::out | std::ios::binary);
    bad.seekp(page * 4096 + 100);
    bad << std::string(3996, '\xA5');
    bad.close();
    for (const char* command : {"db check --database ", "audit verify --database ", "db verify "}) {
      const ProgramRun check = run(command + file("bad.sqlite"));
      EXPECT_EQ(check.code, codeOf(ErrorCode::kVerifyFailed)) << command << page << check.err;
    }
  }
}

TEST_F(RecordSafety, AReportNeverReplacesADatabase) {
  makeRecord("sound.sqlite");
  overwritten(file("damaged.sqlite"), noise(100));
  for (const char* name : {"sound.sqlite", "damaged.sqlite"}) {
    const std::string before = readFile(file(name));

    EXPECT_EQ(refusalFrom([&] { writeFileAtomically(file(name), "a,b\n"); }).code, ErrorCode::kFileUnwritable)
        << name;

    EXPECT_EQ(readFile(file(name)), before) << name;
  }
  writeFileAtomically(file("picture.jpg"), noise(100 * 4096));
  writeFileAtomically(file("picture.jpg"), "another");
  EXPECT_EQ(readFile(file("picture.jpg")), "another");
}

TEST_F(RecordSafety, LeftoversOfKilledProgramsAreRemovedAndFilesInUseStay) {
  makeRecord("record.sqlite");
  for (const char* left : {"old.sqlite.part", "old.sqlite.part-wal", "unrelated.part"}) {
    std::ofstream(file(left)) << "left";
  }
  std::ofstream(file("old.sqlite.part.lock")) << "4194399\ntorsio\nelsewhere\n";  // no process has this id
  const fs::path check = fs::temp_directory_path() / ("torsio-check-" + folder_.filename().string());
  fs::create_directories(check);
  std::ofstream(check / "copy.sqlite") << "names";
  std::ofstream(check / "in-use") << "4194399\ntorsio\n\n";
  const fs::path nobodys = check.string() + "-nobody";  // killed before it wrote the owner of the lock
  fs::create_directories(nobodys);
  std::ofstream(nobodys / "in-use").close();
  const FileInTheMaking mine(file("mine.sqlite"));
  std::ofstream(mine.path()) << "being made";

  const ProgramRun backup =
      run("db backup --as-system " + file("b.sqlite") + " --database " + file("record.sqlite"));

  EXPECT_EQ(backup.code, 0) << backup.err;
  EXPECT_FALSE(fs::exists(check));
  EXPECT_FALSE(fs::exists(nobodys));
  EXPECT_TRUE(fs::exists(mine.path()));
  EXPECT_TRUE(fs::exists(file("unrelated.part")));
  fs::remove_all(check);
}

TEST_F(RecordSafety, EveryWayOfSwappingKeepsBothFiles) {
  for (const ExchangeBy way : {ExchangeBy::kOneStep, ExchangeBy::kHardLink, ExchangeBy::kNote}) {
    std::ofstream(file("record"), std::ios::trunc) << "old";
    std::ofstream(file("ready"), std::ios::trunc) << "new";
    const fs::path aside = freeName(file("aside"));

    exchangeRecord(file("ready"), file("record"), aside, way);

    EXPECT_EQ(readFile(file("record")), "new");
    EXPECT_EQ(readFile(aside), "old");
    EXPECT_FALSE(fs::exists(file("ready")));
    EXPECT_FALSE(fs::exists(file("record.restoring")));
  }
}

TEST_F(RecordSafety, ARecordThatLostItsNameGetsItBackAtTheNextStart) {
  makeRecord("record.sqlite");
  {
    Connection connection = openDatabase(file("record.sqlite"), OpenMode::kReadWrite);
    connection.executeVerbatim("PRAGMA journal_mode = DELETE");
  }
  fs::rename(file("record.sqlite"), file("record.sqlite.before-restore-1"));
  std::ofstream(file("record.sqlite.restoring")) << "record.sqlite.before-restore-1";

  const Connection connection = openRecord(file("record.sqlite"), OpenMode::kReadWrite);

  EXPECT_EQ(personIn("record.sqlite").substr(0, 4), "real");
  EXPECT_FALSE(fs::exists(file("record.sqlite.restoring")));
}

}  // namespace
}  // namespace torsio
