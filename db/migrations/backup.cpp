// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/backup.h"

#include <array>
#include <system_error>

#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/migrations/migrations.h"
#include "sim/base/contracts.h"
#include "sim/base/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

/// A database and what may lie beside it.
constexpr std::array<const char*, 4> kParts{"", "-wal", "-shm", "-journal"};

fs::path withSuffix(fs::path file, const char* suffix) {
  file += suffix;
  return file;
}

void removeWithLogs(const fs::path& file) noexcept {
  std::error_code ignored;
  for (const char* suffix : kParts) {
    fs::remove(withSuffix(file, suffix), ignored);
  }
}

std::int64_t rowsOf(Connection& connection, const char* table) {
  Statement row = connection.prepare(std::string("SELECT count(*) FROM ") + table);
  row.execute();
  return row.step() ? row.int64(0) : 0;
}

/// Folds the write-ahead log into the file, which needs it for ourselves: fails while anybody else has it
/// open. A file that is too damaged for that is put aside with its log as it is.
void takeOver(const fs::path& target) {
  try {
    Connection connection = openDatabase(target.string(), OpenMode::kReadWrite, 0);
    connection.executeVerbatim("PRAGMA journal_mode = DELETE");
  } catch (const DbError& error) {
    if (error.fault() == DbFault::kBusy) {
      throw Error(ErrorCode::kDatabase, Text::tr("is open in another program"), target.string(),
                  Text::tr("Close Torsio at every station and try again"));
    }
  } catch (const Error&) {
    return;  // not a database any more
  }
}

void moveAside(const fs::path& target) {
  const fs::path aside = withSuffix(target, ".before-restore");
  removeWithLogs(aside);
  for (const char* suffix : kParts) {
    const fs::path part = withSuffix(target, suffix);
    if (fs::exists(part)) {
      fs::rename(part, withSuffix(aside, suffix));
    }
  }
}

/// After moveAside, when nothing could take the place.
void putBack(const fs::path& target) noexcept {
  std::error_code ignored;
  const fs::path aside = withSuffix(target, ".before-restore");
  if (fs::exists(target, ignored)) {
    return;
  }
  for (const char* suffix : kParts) {
    if (fs::exists(withSuffix(aside, suffix), ignored)) {
      fs::rename(withSuffix(aside, suffix), withSuffix(target, suffix), ignored);
    }
  }
}

}  // namespace

std::vector<std::string> integrityFindings(Connection& connection) {
  std::vector<std::string> findings;
  if (connection.engine() != Engine::kSqlite) {
    return findings;  // the server keeps its own files
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

/// Writes one page in rollback mode: the commit makes the system flush the whole file to the disk, which
/// VACUUM INTO and copying leave open.
void settleSqlite(const fs::path& copy) {
  Connection connection = openDatabase(copy.string(), OpenMode::kReadWrite);
  const std::vector<std::string> findings = integrityFindings(connection);
  if (!findings.empty()) {
    throw Error(ErrorCode::kVerifyFailed, Text::tr("backup does not pass its check: %1", findings.front()),
                copy.string(), Text::tr("Check the disk, and the database itself"));
  }
  connection.executeVerbatim("PRAGMA journal_mode = DELETE");
  connection.executeVerbatim("PRAGMA synchronous = FULL");
  connection.executeVerbatim("PRAGMA user_version = 1");
}

void replaceSqlite(const fs::path& ready, const fs::path& target) {
  try {
    if (fs::exists(target)) {
      takeOver(target);
      moveAside(target);
    }
    fs::rename(ready, target);
  } catch (const fs::filesystem_error& error) {
    putBack(target);
    throw Error(ErrorCode::kFileUnwritable, Text::tr("backup cannot be restored: %1", error.code().message()),
                target.string(), Text::tr("Check the folder and the free space"));
  }
}

void backupSqlite(Connection& connection, const fs::path& target) {
  TORSIO_EXPECTS(connection.engine() == Engine::kSqlite && !connection.inTransaction());
  const fs::path temporary = temporaryBeside(target);
  removeWithLogs(temporary);
  try {
    connection.execute("VACUUM INTO ?", {temporary.string()});
    settleSqlite(temporary);
  } catch (...) {
    removeWithLogs(temporary);
    throw;
  }
  std::error_code failed;
  fs::rename(temporary, target, failed);
  if (failed) {
    removeWithLogs(temporary);
    throw Error(ErrorCode::kFileUnwritable, Text::tr("backup cannot be written"), target.string(),
                Text::tr("Choose a folder in which you may write"));
  }
}

BackupContent checkBackup(const fs::path& backup) {
  Connection connection = openDatabase(backup.string(), OpenMode::kReadOnly);
  BackupContent content;
  content.schemaVersion = checkSchema(connection, embeddedMigrations()).version;
  if (content.schemaVersion == 0) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("holds no Torsio record"), backup.string(),
                Text::tr("Choose another file"));
  }
  const std::vector<std::string> findings = integrityFindings(connection);
  if (!findings.empty()) {
    throw Error(ErrorCode::kVerifyFailed, Text::tr("backup is damaged: %1", findings.front()),
                backup.string(), Text::tr("Use an older backup"));
  }
  content.trials = rowsOf(connection, "trial");
  content.marks = rowsOf(connection, "training_mark") + rowsOf(connection, "evaluation_mark");
  return content;
}

void restoreSqlite(const fs::path& backup, const fs::path& target) {
  (void)checkBackup(backup);
  const fs::path temporary = temporaryBeside(target);
  removeWithLogs(temporary);
  try {
    fs::copy_file(backup, temporary);
    settleSqlite(temporary);
    replaceSqlite(temporary, target);
  } catch (const fs::filesystem_error& error) {
    removeWithLogs(temporary);
    throw Error(ErrorCode::kFileUnwritable, Text::tr("backup cannot be restored: %1", error.code().message()),
                target.string(), Text::tr("Check the folder and the free space"));
  } catch (...) {
    removeWithLogs(temporary);
    throw;
  }
}

}  // namespace torsio
