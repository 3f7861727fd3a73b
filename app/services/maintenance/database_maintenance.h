// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/migrations/backup.h"
#include "db/repository/system/record_copy.h"

namespace torsio {

class Connection;

/// Result of checking a whole database.
struct DatabaseCheck {
  std::string location{};  ///< without a password
  std::int64_t schemaVersion = 0;
  std::vector<std::string> damage{};  ///< problems of file and references reported by the engine
  std::vector<AuditFinding> audit{};  ///< mismatches with the audit trail
  std::int64_t auditEntries = 0;
  /// Entries of the trail dated before an earlier one or in the future (by more than ten minutes): the clock
  /// of a station was wrong, or set. Not a finding: the order of the trail does not depend on it.
  std::vector<Text> clock{};

  [[nodiscard]] bool sound() const noexcept { return damage.empty() && audit.empty(); }
};

/// Result of reading a backup completely.
struct BackupCheck {
  BackupContent content{};
  DatabaseCheck database{};
};

/// Throws Error (kUsage) for a PostgreSQL address, naming the server's own tools.
void requireOwnRestore(const std::string& locator);

/// Test restore: reads the whole backup in a separate copy, including its audit trail; the file is not
/// changed. `look` may read the copy, with its schema migrated, if it is sound.
[[nodiscard]] BackupCheck verifyBackup(const std::filesystem::path& backup,
                                       const ProgressCallback& progress = {},
                                       const std::function<void(Connection&)>& look = {});
/// Removes leftovers of killed programs: unfinished databases in the folder of the record at `locator`, and
/// copies of backups that were being checked. Leaves alone what another program is using.
void sweepLeftovers(const std::string& locator);

/// Checks a database read-only; needs only read access to the file. Damage is a finding, not an error.
/// PostgreSQL servers check their own files; here only schema and audit trail are checked.
[[nodiscard]] DatabaseCheck checkDatabase(const std::string& locator);

/// Backs up the database into one file while others work; the file is checked before it gets its name, and
/// contains the audit entry. Replaces an older backup of that name by default, because the dialog has asked.
/// For a server as dumpServer(). kDatabaseBackup. Throws Error: kFileUnwritable if `target` exists and may
/// not be replaced; like dumpServer().
BackupContent backUpDatabase(SessionContext& session, const std::filesystem::path& target,
                             const ProgressCallback& progress = {}, Replace replace = Replace::kBackup);
/// Checks the session's database. kDatabaseBackup; audited with the result.
[[nodiscard]] DatabaseCheck checkDatabase(SessionContext& session, const ProgressCallback& progress = {});

/// Copies a file in steps with progress; removes a partial copy if `progress` throws. Throws Error
/// (kFileUnwritable, kFileMissing).
void copyStepwise(const std::filesystem::path& from, const std::filesystem::path& to,
                  const ProgressCallback& progress = {});

/// What becomes of the record that is copied.
enum class CopyUse {
  kUndecided,  ///< it stays the living one for now
  kMove,       ///< it takes nothing new from before the copying on (noteMoving()); the caller ends with
               ///< noteMoved()
};

/// Copies a record to another database: SQLite to PostgreSQL or back. Reads the source as of one moment
/// without changing it; the target must be a new file or an empty database, and receives everything in one
/// transaction or stays as it was. Compares counts and hashes of every table and verifies the target's audit
/// trail before committing. Audited in the source before copying (so in the copy too) and after a failure.
/// kDatabaseRestore. Throws Error: kUsage if both are the same, kBadData if the target is not empty,
/// kVerifyFailed if the copy differs.
[[nodiscard]] CopyReport copyDatabase(SessionContext& session, const std::string& to,
                                      const ProgressCallback& progress = {},
                                      CopyUse use = CopyUse::kUndecided);

}  // namespace torsio
