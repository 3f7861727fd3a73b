// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "sim/core/file_lock.h"

namespace torsio {

/// Suffixes of a database file and the files that SQLite may put beside it.
inline constexpr const char* kDatabaseParts[] = {"", "-wal", "-shm", "-journal"};

/// Returns `file` with `suffix` appended to its name.
[[nodiscard]] std::filesystem::path withSuffix(std::filesystem::path file, const std::string& suffix);
/// Removes a database file and its logs, if present.
void removeDatabase(const std::filesystem::path& file) noexcept;
/// Returns `wanted` if the name is free, otherwise the first free one of "wanted-2", "wanted-3" ... (before
/// an ending `.sqlite`).
[[nodiscard]] std::filesystem::path freeName(const std::filesystem::path& wanted);

/// Returns the target of a symbolic link, or `file` itself.
[[nodiscard]] std::filesystem::path linkTarget(const std::filesystem::path& file);

/// Returns the first free name of "<stem>-1", "<stem>-2" ...
[[nodiscard]] std::filesystem::path numberedName(const std::filesystem::path& stem);

/// The temporary file or folder "<target>.part" of something under construction. A lock file beside it is
/// held for the lifetime of this object; the temporary is removed at the end unless it was renamed. What a
/// killed program leaves behind is recognised by its lock file and swept.
class FileInTheMaking {
 public:
  /// Removes leftovers with that name. Throws Error (kFileUnwritable) if another program is still making
  /// `target` after `patience`, or its folder is not writable.
  explicit FileInTheMaking(const std::filesystem::path& target, std::chrono::milliseconds patience = {});
  FileInTheMaking(const FileInTheMaking&) = delete;
  FileInTheMaking& operator=(const FileInTheMaking&) = delete;
  ~FileInTheMaking();

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  FileLock lock_;
};

/// Removes leftovers of killed programs from `folder`. Keeps what another program is making now, and every
/// file without one of our lock files.
void sweepUnfinished(const std::filesystem::path& folder);

/// Ways to exchange two files, tried in this order if the file system refuses one.
enum class ExchangeBy {
  kOneStep,   ///< one atomic exchange of both names (Linux)
  kHardLink,  ///< a second name for the old file, then an atomic replacement
  kNote,      ///< two renames, and a note beside the record from which recoverRecord() completes them
};

/// Replaces the record `target` by the file `ready` and keeps the old one as `aside`, a free name, all in one
/// folder. Whenever the program is killed, a complete record has the name `target` or (kNote) is restored to
/// it by recoverRecord(). Throws std::filesystem::filesystem_error; the record is then unchanged.
void exchangeRecord(const std::filesystem::path& ready, const std::filesystem::path& target,
                    const std::filesystem::path& aside, ExchangeBy first = ExchangeBy::kOneStep);

/// Completes an exchange during which the program was killed: if `record` is missing and a note names its
/// present file, that is renamed back.
void recoverRecord(const std::filesystem::path& record);

}  // namespace torsio
