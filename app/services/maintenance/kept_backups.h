// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/maintenance/database_maintenance.h"

namespace torsio {

/// How many backups of a folder stay: the newest one of each of the last so many days, weeks (from Monday)
/// and months that have one; UTC.
struct KeepRule {
  int days = 7;
  int weeks = 5;
  int months = 12;
};

/// Reads "7,5,12". Throws Error{kBadParameter} unless these are three whole numbers from 0 to 1000, the first
/// of them at least 1.
[[nodiscard]] KeepRule keepRule(const std::string& text);

/// Returns the places of those backups, by the times at which they were made (UTC, us), that the rule lets
/// go. The newest always stays.
[[nodiscard]] std::vector<std::size_t> outdated(const KeepRule& rule, std::span<const std::int64_t> made_us);

/// A backup that was written into a folder, and what was removed there for it.
struct KeptBackup {
  std::filesystem::path file{};
  BackupContent content{};
  std::vector<std::filesystem::path> removed{};
};

/// Backs the record up into `folder`, which is made if missing, under the name torsio-2026-11-30T013000Z with
/// the ending .sqlite or .dump, then removes the backups that the rule lets go: only files of such a name
/// that the record knows as its own backups of this station; each removal is audited. Throws like
/// backUpDatabase(); then nothing is removed.
KeptBackup keepBackup(SessionContext& session, const std::filesystem::path& folder, const KeepRule& rule);

/// Returns the newest file of such a name in a folder. Throws Error{kFileUnreadable} if there is none.
[[nodiscard]] std::filesystem::path newestBackup(const std::filesystem::path& folder);

}  // namespace torsio
