// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace torsio {

class Connection;

/// What a new backup may replace.
enum class Replace { kNothing, kBackup };

/// Writes a consistent copy of an open SQLite database while others keep working, checks it, marks it as a
/// backup and renames it to `target`. On failure nothing is left behind and an existing `target` is
/// untouched. Throws DbError; Error kFileUnwritable if `target` exists and may not be replaced, and always if
/// it is a database but not a backup: a record is never replaced by a backup.
void backupSqlite(Connection& connection, const std::filesystem::path& target,
                  Replace replace = Replace::kNothing);
/// Throws what backupSqlite() would throw if `target` may not be replaced.
void requireReplaceable(const std::filesystem::path& target, Replace replace);

/// Contents of a backup that was read from end to end.
struct BackupContent {
  std::int64_t schemaVersion = 0;
  std::int64_t trials = 0;
  std::int64_t marks = 0;
};

/// Returns the content of an open record.
[[nodiscard]] BackupContent contentOfRecord(Connection& connection);

/// Reads and checks a backup without changing it. Throws Error (kFileMissing, kFileUnreadable, kNewerSchema,
/// kVerifyFailed).
[[nodiscard]] BackupContent checkBackup(const std::filesystem::path& backup);

/// Replaces `target` by a checked copy of `backup`. The old file is kept as "<target>.before-restore-N" with
/// the first free number; returns that path, empty if there was none. A complete record has the name `target`
/// at every instant (exchangeRecord). Throws Error (kDatabase) if another program has `target` open. Nothing
/// is changed then, nor if the check fails or `finish` throws; `finish` may write to the copy and must close
/// it.
std::filesystem::path restoreSqlite(const std::filesystem::path& backup, const std::filesystem::path& target,
                                    const std::function<void(const std::filesystem::path&)>& finish = {});

/// Reads a database file completely and flushes it to disk before it replaces a record. Throws Error
/// (kVerifyFailed) if it is damaged.
void flushSqlite(const std::filesystem::path& copy);

/// Replaces `target` by `ready`, a settled file in the same folder, like restoreSqlite. Throws Error
/// (kDatabase) if another program or connection has `target` open, (kFileUnwritable); both files are then
/// unchanged.
std::filesystem::path replaceSqlite(const std::filesystem::path& ready, const std::filesystem::path& target);

/// Checkpoints the write-ahead log of an open file and switches it off. Throws Error (kFileUnwritable) if the
/// checkpoint was incomplete: the engine then keeps the log.
void disableWriteAheadLog(Connection& connection);

/// Checkpoints the write-ahead log into the file so that it can be moved alone. Returns false if the file is
/// no longer a database or the disk is full. Throws Error (kDatabase) if anybody else has it open.
bool checkpointSqlite(const std::filesystem::path& file);

/// Returns the engine's findings about the file and its references; empty: it is sound.
[[nodiscard]] std::vector<std::string> integrityFindings(Connection& connection);

class Connection;

/// Checkpoints and truncates the write-ahead log, so that erased data do not survive in it. Postponed while
/// others read or write. No effect on a server. Outside a transaction.
void truncateLog(Connection& connection);

/// Returns the space of removed rows to the disk and truncates the log. Skipped while others read or write.
/// No effect on a server, which does it by itself. Outside a transaction.
void compactDatabase(Connection& connection);

}  // namespace torsio
