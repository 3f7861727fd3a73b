// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace torsio {

class Connection;

/// What may be replaced by a new backup.
enum class Replace { kNothing, kBackup };

/// Writes a consistent copy of an open SQLite database while others go on working, checks it, marks it as a
/// backup, and renames it to `target`. On failure nothing is left behind and an older `target` is untouched.
/// Throws DbError, Error: kFileUnwritable when `target` exists and nothing may be replaced, and always when
/// it is a database but no backup: a record is never replaced by one.
void backupSqlite(Connection& connection, const std::filesystem::path& target,
                  Replace replace = Replace::kNothing);
/// Throws what backupSqlite() would when `target` must stay.
void requireReplaceable(const std::filesystem::path& target, Replace replace);

/// What a backup holds, after it was read from end to end.
struct BackupContent {
  std::int64_t schemaVersion = 0;
  std::int64_t trials = 0;
  std::int64_t marks = 0;
};

/// Reads and checks a backup without changing it. Throws Error (kFileMissing, kFileUnreadable, kNewerSchema,
/// kVerifyFailed).
[[nodiscard]] BackupContent checkBackup(const std::filesystem::path& backup);

/// Puts a checked copy of `backup` in place of `target`. What was there is kept beside it as
/// "<target>.before-restore-N", the first free number; returns that path, empty when nothing was there. There
/// is a whole record under the name `target` at every instant (exchangeRecord). Throws Error (kDatabase) when
/// another program has `target` open; nothing is changed then, nor when the backup does not pass its check or
/// `finish`, which may write to the copy and must have closed it, throws.
std::filesystem::path restoreSqlite(const std::filesystem::path& backup, const std::filesystem::path& target,
                                    const std::function<void(const std::filesystem::path&)>& finish = {});

/// Reads all of a database file that is to take a record's place, and makes sure that it lies on the disk
/// whole. Throws Error (kVerifyFailed) when it is not sound.
void settleSqlite(const std::filesystem::path& copy);

/// Puts `ready`, a settled file in the same folder, in place of `target`, as restoreSqlite does. Throws Error
/// (kDatabase) when another program or another connection has `target` open, (kFileUnwritable); then `target`
/// and `ready` are as before.
std::filesystem::path replaceSqlite(const std::filesystem::path& ready, const std::filesystem::path& target);

/// Folds the write-ahead log of an open file into it and works without one from then on. Throws Error
/// (kFileUnwritable) when not all of it could be folded: the engine only keeps the log then.
void leaveLog(Connection& connection);

/// Folds the write-ahead log into the file, so that it can be moved alone. Returns false for a file that is
/// no database any more, or when the disk is full. Throws Error (kDatabase) when anybody else has it open.
bool foldSqlite(const std::filesystem::path& file);

/// What the engine finds wrong with the file or its references; empty: nothing.
[[nodiscard]] std::vector<std::string> integrityFindings(Connection& connection);

}  // namespace torsio
