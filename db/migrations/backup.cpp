// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/backup.h"

#include <cstdint>
#include <fstream>
#include <string_view>
#include <system_error>

#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "sim/core/contracts.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

// PRAGMA application_id of a file: "TORB" for a backup, "TORS" for a record.
constexpr std::uint32_t kBackupMark = 0x544F5242;
constexpr std::uint32_t kRecordMark = 0x544F5253;

/// The head of a database file, https://www.sqlite.org/fileformat2.html#the_database_header.
struct SqliteHead {
  bool database = false;
  bool writeAheadLog = false;  // the database was opened for writing
  std::uint32_t application = 0;
};

SqliteHead headOf(const fs::path& file) {
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  constexpr std::size_t kHeadLength = 100;
  constexpr std::size_t kWriteVersion = 18;
  constexpr std::size_t kApplication = 68;
  std::ifstream in(file, std::ios::binary);
  std::string head(kHeadLength, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (!in || !head.starts_with(kMagic)) {
    return {};
  }
  SqliteHead found{.database = true, .writeAheadLog = head[kWriteVersion] == 2};
  for (std::size_t i = 0; i < 4; ++i) {
    found.application = found.application << 8U | static_cast<std::uint8_t>(head[kApplication + i]);
  }
  return found;
}

std::int64_t rowsOf(Connection& connection, const char* table) {
  Statement row = connection.prepare(std::string("SELECT count(*) FROM ") + table);
  row.execute();
  return row.step() ? row.int64(0) : 0;
}

/// Writes one page in rollback mode: the commit makes the system flush the whole file to disk, which VACUUM
/// INTO and copying do not.
void settleAs(std::uint32_t mark, const fs::path& copy) {
  Connection connection = openDatabase(copy.string(), OpenMode::kReadWrite);
  const std::vector<std::string> findings = integrityFindings(connection);
  if (!findings.empty()) {
    throw Error(ErrorCode::kVerifyFailed, Text::tr("backup does not pass its check: %1", findings.front()),
                copy.string(), Text::tr("Check the disk, and the database itself"));
  }
  disableWriteAheadLog(connection);
  connection.executeVerbatim("PRAGMA synchronous = FULL");
  connection.executeVerbatim("PRAGMA application_id = " + std::to_string(mark));
  connection.executeVerbatim("PRAGMA user_version = 1");
}

/// Moves the logs of a damaged database beside the file `to`.
void moveLogs(const fs::path& from, const fs::path& to) {
  for (const char* suffix : {"-wal", "-shm", "-journal"}) {
    if (fs::exists(withSuffix(from, suffix))) {
      fs::rename(withSuffix(from, suffix), withSuffix(to, suffix));
    }
  }
}

[[noreturn]] void cannotRestore(const fs::path& target, const fs::filesystem_error& error) {
  throw Error(ErrorCode::kFileUnwritable, Text::tr("backup cannot be restored: %1", error.code().message()),
              target.string(), Text::tr("Check the folder and the free space"));
}

}  // namespace

void requireReplaceable(const fs::path& target, Replace replace) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (!fs::exists(status)) {
    return;
  }
  const bool file = fs::is_regular_file(status);
  const SqliteHead head = file ? headOf(target) : SqliteHead{};
  const bool backup = head.database && !head.writeAheadLog && head.application == kBackupMark;
  if (!backup && !(file && fs::file_size(target, ignored) == 0)) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("is not a backup, so no backup replaces it"),
                target.string(), Text::tr("Name another file"));
  }
  if (replace == Replace::kNothing) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("exists already"), target.string(),
                Text::tr("Name another file, or give --replace"));
  }
}

std::vector<std::string> integrityFindings(Connection& connection) {
  std::vector<std::string> findings;
  if (connection.engine() != Engine::kSqlite) {
    return findings;  // the server takes care of its own files
  }
  Statement check = connection.prepare("PRAGMA integrity_check");
  check.execute();
  while (check.step()) {
    if (check.text(0) != "ok") {
      findings.push_back(check.text(0));
    }
  }
  Statement references = connection.prepare("PRAGMA foreign_key_check");
  references.execute();
  while (references.step()) {
    findings.push_back("a row of " + references.text(0) + " refers to a missing row of " +
                       references.text(2));
  }
  return findings;
}

void disableWriteAheadLog(Connection& connection) {
  std::string mode;
  Statement answer = connection.selectVerbatim("PRAGMA journal_mode = DELETE");
  while (answer.step()) {
    mode = answer.text(0);
  }
  if (mode != "delete") {
    refuseUnwritable(connection.location());
  }
}

void flushSqlite(const fs::path& copy) {
  settleAs(kRecordMark, copy);
}

bool checkpointSqlite(const fs::path& file) {
  try {
    Connection connection = openDatabase(file.string(), OpenMode::kReadWrite, 0);
    disableWriteAheadLog(connection);
    return true;
  } catch (const DbError& error) {
    if (error.fault() == DbFault::kBusy) {
      throw Error(ErrorCode::kDatabase, Text::tr("is open in another program"), file.string(),
                  Text::tr("Close Torsio at every station and try again"));
    }
  } catch (const Error&) {
    return false;
  }
  return false;
}

fs::path replaceSqlite(const fs::path& ready, const fs::path& target) {
  fs::path aside;
  try {
    if (!fs::exists(target)) {
      fs::rename(ready, target);
      return aside;
    }
    const bool whole = checkpointSqlite(target);
    aside = numberedName(withSuffix(target, ".before-restore"));
    if (!whole) {
      moveLogs(target, aside);  // they must not meet the restored file
    }
    try {
      exchangeRecord(ready, target, aside);
    } catch (const fs::filesystem_error&) {
      moveLogs(aside, target);
      throw;
    }
  } catch (const fs::filesystem_error& error) {
    cannotRestore(target, error);
  }
  return aside;
}

void backupSqlite(Connection& connection, const fs::path& target, Replace replace) {
  TORSIO_EXPECTS(connection.engine() == Engine::kSqlite && !connection.inTransaction());
  requireReplaceable(target, replace);
  const FileInTheMaking copy(target);
  connection.execute("VACUUM INTO ?", {copy.path().string()});
  settleAs(kBackupMark, copy.path());
  requireReplaceable(target, replace);  // whoever was faster wins
  std::error_code failed;
  fs::rename(copy.path(), target, failed);
  if (failed) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("backup cannot be written"), target.string(),
                Text::tr("Choose a folder in which you may write"));
  }
}

BackupContent contentOfRecord(Connection& connection) {
  return {.schemaVersion = checkSchema(connection, embeddedMigrations()).version,
          .trials = rowsOf(connection, "trial"),
          .marks = rowsOf(connection, "training_mark") + rowsOf(connection, "evaluation_mark")};
}

BackupContent checkBackup(const fs::path& backup) {
  Connection connection = openDatabase(backup.string(), OpenMode::kReadOnly);
  if (checkSchema(connection, embeddedMigrations()).version == 0) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("contains no Torsio record"), backup.string(),
                Text::tr("Choose another file"));
  }
  const std::vector<std::string> findings = integrityFindings(connection);
  if (!findings.empty()) {
    throw Error(ErrorCode::kVerifyFailed, Text::tr("backup is damaged: %1", findings.front()),
                backup.string(), Text::tr("Use an older backup"));
  }
  return contentOfRecord(connection);
}

fs::path restoreSqlite(const fs::path& backup, const fs::path& target,
                       const std::function<void(const fs::path&)>& finish) {
  (void)checkBackup(backup);
  const FileInTheMaking ready(target);
  try {
    fs::copy_file(backup, ready.path());
  } catch (const fs::filesystem_error& error) {
    cannotRestore(target, error);
  }
  if (finish) {
    finish(ready.path());
  }
  flushSqlite(ready.path());
  return replaceSqlite(ready.path(), target);
}

namespace {

/// Runs housekeeping that other users may postpone.
void runWhenFree(Connection& connection, const char* sql) {
  if (connection.engine() != Engine::kSqlite || connection.inTransaction()) {
    return;
  }
  try {
    connection.executeVerbatim(sql);
  } catch (const DbError& error) {
    if (!error.retryable() && error.fault() != DbFault::kFull) {
      throw;
    }
  }
}

}  // namespace

void truncateLog(Connection& connection) {
  runWhenFree(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
}

void compactDatabase(Connection& connection) {
  runWhenFree(connection, "VACUUM");
  truncateLog(connection);
}

}  // namespace torsio
