// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace torsio {

// Backups of a record on a PostgreSQL server, by the server's own programs (package postgresql-client).

/// Writes the record at `locator` as of one moment into a new file by pg_dump, reads the file from end to end
/// by pg_restore, and only then gives it the name `target`. Needs the account that owns the tables. Throws
/// Error: kFileMissing without these programs, kFileUnwritable, kDatabase with what pg_dump says (then
/// nothing is left behind).
void dumpServer(const std::string& locator, const std::filesystem::path& target);

/// Returns whether a file is such a backup.
[[nodiscard]] bool isDump(const std::filesystem::path& file);

/// Reads such a backup from end to end, without a server. Throws Error{kVerifyFailed} if it is damaged.
void readDump(const std::filesystem::path& file);

}  // namespace torsio
