// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "sim/core/file_lock.h"

namespace torsio {

/// A database and what SQLite may lay beside it.
inline constexpr const char* kDatabaseParts[] = {"", "-wal", "-shm", "-journal"};

/// Returns `file` with `suffix` at the end of its name.
[[nodiscard]] std::filesystem::path withSuffix(std::filesystem::path file, const std::string& suffix);
/// Removes a database file with its logs, as far as they are there.
void removeDatabase(const std::filesystem::path& file) noexcept;
/// Returns `wanted` if nothing has that name, else the first free one of "wanted-2", "wanted-3" ... (before
/// the ending `.sqlite`, if there is one).
[[nodiscard]] std::filesystem::path freeName(const std::filesystem::path& wanted);

/// Returns the file that a link leads to, or `file` itself when it is none.
[[nodiscard]] std::filesystem::path beyondLinks(const std::filesystem::path& file);

/// Returns the first of "<stem>-1", "<stem>-2" ... that nothing has.
[[nodiscard]] std::filesystem::path numberedName(const std::filesystem::path& stem);

/// The temporary file "<target>.part" of a database, or a folder, that is being made: held by a lock file
/// beside it while this object lives, gone at the end unless it was renamed. What a killed program leaves is
/// found by its lock, and swept.
class FileInTheMaking {
 public:
  /// Removes leftovers of that name. Throws Error (kFileUnwritable) when another program is making `target`
  /// for longer than `patience`, or its folder cannot be written.
  explicit FileInTheMaking(const std::filesystem::path& target, std::chrono::milliseconds patience = {});
  FileInTheMaking(const FileInTheMaking&) = delete;
  FileInTheMaking& operator=(const FileInTheMaking&) = delete;
  ~FileInTheMaking();

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  FileLock lock_;
};

/// Removes from `folder` what killed programs left there of what was in the making. What another program is
/// making now stays, and so does every file without a lock of ours beside it.
void sweepUnfinished(const std::filesystem::path& folder);

}  // namespace torsio
