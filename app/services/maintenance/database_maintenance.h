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

namespace torsio {

class Connection;

/// What a look at a whole database found.
struct DatabaseCheck {
  std::string location{};  ///< without a password
  std::int64_t schemaVersion = 0;
  std::vector<std::string> damage{};  ///< what the engine finds wrong with file and references
  std::vector<AuditFinding> audit{};  ///< what does not fit the audit trail
  std::int64_t auditEntries = 0;

  [[nodiscard]] bool sound() const noexcept { return damage.empty() && audit.empty(); }
};

/// A backup that was read from end to end like a database in use.
struct BackupCheck {
  BackupContent content{};
  DatabaseCheck database{};
};

/// A server has tools of its own: throw Error (kUsage) that names them, for a PostgreSQL address.
void requireOwnBackups(const std::string& locator);
void requireOwnRestore(const std::string& locator);

/// A test restore: reads all of the backup in a copy of its own, with its audit trail; the file stays as it
/// is. `look` may read the copy, brought up to date, when it was found sound.
[[nodiscard]] BackupCheck verifyBackup(const std::filesystem::path& backup,
                                       const ProgressCallback& progress = {},
                                       const std::function<void(Connection&)>& look = {});
/// Removes what killed programs left: databases in the making in the folder of the record at `locator`, and
/// copies of backups that were being checked. Leaves alone what another program is at.
void sweepLeftovers(const std::string& locator);

/// Opens for reading only, as whoever may read the file; damage is a finding, not an error. For PostgreSQL
/// the server keeps its own files: schema and audit trail are checked.
[[nodiscard]] DatabaseCheck checkDatabase(const std::string& locator);

/// Copies the database while others work, into one file that is checked before it gets its name; the audit
/// entry is in the copy, too. By default an older backup of that name goes: the dialog has asked.
/// kDatabaseBackup. Throws Error: kUsage for PostgreSQL (its own pg_dump does it), kFileUnwritable when
/// `target` exists and may not be replaced.
BackupContent backUpDatabase(SessionContext& session, const std::filesystem::path& target,
                             const ProgressCallback& progress = {}, Replace replace = Replace::kBackup);
/// kDatabaseBackup, audited with the result.
[[nodiscard]] DatabaseCheck checkDatabase(SessionContext& session, const ProgressCallback& progress = {});

/// Copies a file in steps, telling the fraction; what was begun is removed again when `progress` throws.
/// Throws Error (kFileUnwritable, kFileMissing).
void copyStepwise(const std::filesystem::path& from, const std::filesystem::path& to,
                  const ProgressCallback& progress = {});

}  // namespace torsio
