// SPDX-License-Identifier: GPL-3.0-or-later
// Unusable SQLite files. Not applicable to servers.
#include <filesystem>
#include <fstream>
#include <sqlite3.h>

#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

class SqliteFileTest : public ::testing::Test {
 protected:
  [[nodiscard]] fs::path file(const std::string& name = "record.sqlite") const {
    return folder_.path() / name;
  }
  static void expectOneLine(const Refusal& refusal) {
    EXPECT_EQ(refusal.text.find('\n'), std::string::npos) << refusal.text;
    EXPECT_FALSE(refusal.text.empty());
  }
  TemporaryFolder folder_;
};

Refusal opening(const fs::path& file, OpenMode mode) {
  return refusalFrom([&] { (void)openRecord(file.string(), mode); });
}

TEST_F(SqliteFileTest, RefusesAMissingFileUnlessItMayBeCreated) {
  const Refusal refusal = opening(file(), OpenMode::kReadWrite);
  EXPECT_EQ(refusal.code, ErrorCode::kFileMissing);
  expectOneLine(refusal);
  EXPECT_FALSE(fs::exists(file()));

  EXPECT_EQ(opening(folder_.path() / "nowhere" / "record.sqlite", OpenMode::kCreate).code,
            ErrorCode::kFileMissing);
}

// SQLite's count of its memory is guarded by one lock, for which all threads of a desk would wait.
TEST_F(SqliteFileTest, CountsNoMemory) {
  const auto connection = openRecord(file().string(), OpenMode::kCreate);
  EXPECT_EQ(sqlite3_memory_used(), 0);
}

TEST_F(SqliteFileTest, RefusesAFolderInPlaceOfAFile) {
  EXPECT_EQ(opening(folder_.path(), OpenMode::kReadWrite).code, ErrorCode::kFileUnreadable);
}

TEST_F(SqliteFileTest, RefusesAReadOnlyFile) {
  { (void)openRecord(file().string(), OpenMode::kCreate); }
  fs::permissions(file(), fs::perms::owner_read);

  const Refusal refusal = opening(file(), OpenMode::kReadWrite);

  EXPECT_EQ(refusal.code, ErrorCode::kFileUnwritable);
  expectOneLine(refusal);
  EXPECT_NE(refusal.text.find("read-only"), std::string::npos);
}

TEST_F(SqliteFileTest, RefusesAReadOnlyFolderAndLeavesNothingBehind) {
  fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);

  const Refusal refusal = opening(file(), OpenMode::kCreate);

  EXPECT_EQ(refusal.code, ErrorCode::kFileUnwritable);
  expectOneLine(refusal);
  fs::permissions(folder_.path(), fs::perms::owner_all);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(SqliteFileTest, RefusesAFolderInWhichNoFileCanBeCreated) {
  if (!fs::is_directory("/proc")) {
    GTEST_SKIP() << "needs a file system that refuses files";
  }
  const Refusal refusal = opening("/proc/record.sqlite", OpenMode::kCreate);
  EXPECT_EQ(refusal.code, ErrorCode::kFileUnwritable);
  expectOneLine(refusal);
}

TEST_F(SqliteFileTest, RefusesAndKeepsAFileThatIsNotADatabase) {
  const std::string text(5000, 'x');
  writeFileAtomically(file(), text);

  const Refusal refusal = opening(file(), OpenMode::kReadWrite);

  EXPECT_EQ(refusal.code, ErrorCode::kFileUnreadable);
  expectOneLine(refusal);
  EXPECT_EQ(readFile(file()), text);
}

TEST_F(SqliteFileTest, RefusesADatabaseOfAnotherProgram) {
  {
    Connection other = openDatabase(file().string(), OpenMode::kCreate);
    other.executeVerbatim("CREATE TABLE address_book (name TEXT)");
  }

  const Refusal refusal = opening(file(), OpenMode::kReadWrite);

  EXPECT_EQ(refusal.code, ErrorCode::kFileUnreadable);
  Connection other = openDatabase(file().string(), OpenMode::kReadWrite);
  EXPECT_EQ(numberFrom(other, "SELECT count(*) FROM sqlite_master"), 1);
}

TEST_F(SqliteFileTest, ReportsADamagedDatabase) {
  // Page 1 keeps its header, so that the file still starts with "SQLite format 3"; the table list behind it
  // is broken.
  { (void)openRecord(file().string(), OpenMode::kCreate); }
  {
    std::fstream stream(file(), std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(100);
    stream << std::string(3900, '\xA5');
  }

  const Refusal refusal = opening(file(), OpenMode::kReadWrite);

  EXPECT_EQ(refusal.code, ErrorCode::kVerifyFailed);
  EXPECT_NE(refusal.text.find("backup"), std::string::npos) << refusal.text;
}

TEST_F(SqliteFileTest, ReadsAnExistingRecordWithoutWriting) {
  { (void)openRecord(file().string(), OpenMode::kCreate); }

  Connection reader = openRecord(file().string(), OpenMode::kReadOnly);

  EXPECT_TRUE(reader.readOnly());
  EXPECT_EQ(numberFrom(reader, "SELECT count(*) FROM person"), 0);
}

TEST_F(SqliteFileTest, UsesAWriteAheadLogAndFlushesEachCommit) {
  Connection connection = openRecord(file().string(), OpenMode::kCreate);
  Statement mode = connection.prepare("PRAGMA journal_mode");
  mode.execute();
  ASSERT_TRUE(mode.step());
  EXPECT_EQ(mode.text(0), "wal");
  EXPECT_EQ(numberFrom(connection, "PRAGMA synchronous"), 2);  // 2 = FULL, sqlite.org/pragma.html
  EXPECT_EQ(numberFrom(connection, "PRAGMA foreign_keys"), 1);
  EXPECT_EQ(numberFrom(connection, "PRAGMA busy_timeout"), kBusyTimeout_ms);
}

}  // namespace
}  // namespace torsio
