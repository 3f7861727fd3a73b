// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/care/database_care.h"

#include <system_error>

#include "db/migrations/migrations.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

void requireSqlite(const std::string& locator, const char* remedy) {
  const Locator parsed = parseLocator(locator);
  if (parsed.engine == Engine::kSqlite) return;
  throw Error(ErrorCode::kUsage, "a PostgreSQL database is backed up and restored by its own tools",
              parsed.shown(), remedy);
}

DatabaseCheck check(Connection& connection) {
  DatabaseCheck result;
  result.location = connection.location();
  result.schemaVersion = checkSchema(connection, embeddedMigrations()).version;
  result.damage = integrityFindings(connection);
  if (!result.damage.empty()) return result;  // a damaged file cannot be read to its end
  AuditRepository audit(connection);
  result.audit = audit.verify();
  result.auditEntries = audit.length();
  return result;
}

/// A copy beside nothing of ours, gone at the end.
class ScratchFile {
 public:
  explicit ScratchFile(const fs::path& original)
      : path_(temporaryBeside(fs::temp_directory_path() / original.filename())) {
    std::error_code failed;
    fs::copy_file(original, path_, fs::copy_options::overwrite_existing, failed);
    if (failed) {
      throw Error(ErrorCode::kFileUnwritable,
                  Text("backup cannot be copied for the test: %1", failed.message()), path_.string(),
                  "Free some space in the temporary folder");
    }
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm", "-journal"}) fs::remove(path_.string() + suffix, ignored);
  }
  [[nodiscard]] const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

}  // namespace

BackupContent backUpDatabase(const std::string& locator, const fs::path& target) {
  requireSqlite(locator, "Use pg_dump --format=custom --file=FILE on the server");
  {
    Connection connection = openRecord(locator, OpenMode::kReadWrite);
    backupSqlite(connection, target);
  }
  return checkBackup(target);
}

BackupCheck verifyBackup(const fs::path& backup) {
  BackupCheck result;
  result.content = checkBackup(backup);
  const ScratchFile copy(backup);
  Connection connection = openRecord(copy.path().string(), OpenMode::kReadWrite, {.backup = false});
  result.database = check(connection);
  result.database.location = backup.string();
  return result;
}

BackupContent restoreDatabase(const fs::path& backup, const std::string& locator) {
  requireSqlite(locator, "Use pg_restore on the server");
  const BackupCheck tested = verifyBackup(backup);
  if (!tested.database.sound()) {
    throw Error(ErrorCode::kVerifyFailed, "the backup is not sound, so nothing was restored", backup.string(),
                "Run torsio db verify on it, and use an older backup");
  }
  restoreSqlite(backup, parseLocator(locator).file);
  return tested.content;
}

DatabaseCheck checkDatabase(const std::string& locator) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  return check(connection);
}

BackupContent backUpDatabase(Workplace& workplace, const fs::path& target) {
  workplace.require(Operation::kDatabaseBackup);
  if (workplace.connection().engine() != Engine::kSqlite) {
    requireSqlite(workplace.key().locator, "Use pg_dump --format=custom --file=FILE on the server");
  }
  // Before the copy, so that the backup itself tells of it.
  workplace.note(
      {.action = "database.backup", .objectKind = "database", .objectId = target.filename().string()});
  backupSqlite(workplace.connection(), target);
  return checkBackup(target);
}

DatabaseCheck checkDatabase(Workplace& workplace) {
  workplace.require(Operation::kDatabaseBackup);
  DatabaseCheck result = check(workplace.connection());
  workplace.note({.action = "database.check",
                  .objectKind = "database",
                  .newJson = R"({"damage":)" + std::to_string(result.damage.size()) + R"(,"audit":)" +
                             std::to_string(result.audit.size()) + "}"});
  return result;
}

}  // namespace torsio
