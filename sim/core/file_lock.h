// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>

namespace torsio {

/// A lock file: held against other programs and threads while this object lives, then removed. The system
/// releases it when its program is killed; a leftover file locks nobody out.
class FileLock {
 public:
  /// Takes the lock unless somebody holds it for longer than `patience`.
  explicit FileLock(std::filesystem::path file, std::chrono::milliseconds patience = {});
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

  [[nodiscard]] bool held() const noexcept { return state_ == State::kHeld; }
  /// Throws Error (kFileUnwritable) unless held: another program is writing `target` now, or its folder
  /// cannot be written.
  void requireHeld(const std::filesystem::path& target) const;

 private:
  enum class State { kHeld, kOthers, kUnwritable };

  State take();

  std::filesystem::path file_;
  int descriptor_ = -1;
  State state_;
};

/// Lock beside something unfinished.
[[nodiscard]] std::filesystem::path lockNameOf(const std::filesystem::path& unfinished);

/// The temporary file "<file>.part" of a file that is being written. Two programs never write the same one;
/// it is removed unless finish() renames it.
class PartFile {
 public:
  /// Throws Error (kFileUnwritable), also when `file` is a database, a folder, a device or a pipe.
  explicit PartFile(const std::filesystem::path& file);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  /// Renames it to its final name. Throws Error (kFileUnwritable).
  void finish();

 private:
  std::filesystem::path file_;
  std::filesystem::path path_;
  FileLock lock_;
};

}  // namespace torsio
