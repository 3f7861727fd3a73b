// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/backup.h"

#include <system_error>

#include "sim/base/contracts.h"
#include "sim/base/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

/// Opens the copy, reads all of it, and writes one page in rollback mode: the commit makes the system flush
/// the whole file to the disk, which VACUUM INTO leaves open.
void checkAndFlush(const fs::path& copy) {
  Connection connection = openDatabase(copy.string(), OpenMode::kReadWrite);
  const std::vector<std::string> findings = integrityFindings(connection);
  if (!findings.empty()) {
    throw Error(ErrorCode::kVerifyFailed, "backup does not pass its check: " + findings.front(),
                copy.string(), "Check the disk, and the database itself");
  }
  connection.executeVerbatim("PRAGMA journal_mode = DELETE");
  connection.executeVerbatim("PRAGMA synchronous = FULL");
  connection.executeVerbatim("PRAGMA user_version = 1");
}

void removeWithLogs(const fs::path& file) noexcept {
  std::error_code ignored;
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) {
    fs::path part = file;
    part += suffix;
    fs::remove(part, ignored);
  }
}

}  // namespace

std::vector<std::string> integrityFindings(Connection& connection) {
  std::vector<std::string> findings;
  if (connection.engine() != Engine::kSqlite) return findings;  // the server keeps its own files
  Statement check = connection.prepare("PRAGMA integrity_check");
  check.execute();
  while (check.step()) {
    if (check.text(0) != "ok") findings.push_back(check.text(0));
  }
  Statement references = connection.prepare("PRAGMA foreign_key_check");
  references.execute();
  while (references.step()) {
    findings.push_back("a row of " + references.text(0) + " refers to a missing row of " +
                       references.text(2));
  }
  return findings;
}

void backupSqlite(Connection& connection, const fs::path& target) {
  TORSIO_EXPECTS(connection.engine() == Engine::kSqlite && !connection.inTransaction());
  const fs::path temporary = temporaryBeside(target);
  removeWithLogs(temporary);
  try {
    connection.execute("VACUUM INTO ?", {temporary.string()});
    checkAndFlush(temporary);
  } catch (...) {
    removeWithLogs(temporary);
    throw;
  }
  std::error_code failed;
  fs::rename(temporary, target, failed);
  if (failed) {
    removeWithLogs(temporary);
    throw Error(ErrorCode::kFileUnwritable, "backup cannot be written", target.string(),
                "Choose a folder in which you may write");
  }
}

}  // namespace torsio
