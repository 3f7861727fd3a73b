// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/file_in_the_making.h"

#include <system_error>
#include <vector>

#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

fs::path withSuffix(fs::path file, const std::string& suffix) {
  file += suffix;
  return file;
}

void removeDatabase(const fs::path& file) noexcept {
  std::error_code ignored;
  for (const char* suffix : kDatabaseParts) {
    fs::remove(withSuffix(file, suffix), ignored);
  }
}

namespace {

/// Removes a database with its logs, any other file, or a folder with its contents.
void removeUnfinished(const fs::path& path) noexcept {
  std::error_code ignored;
  if (fs::is_directory(fs::symlink_status(path, ignored))) {
    fs::remove_all(path, ignored);
  }
  removeDatabase(path);
}

}  // namespace

fs::path freeName(const fs::path& wanted) {
  constexpr const char* kEnding = ".sqlite";
  const std::string ending = wanted.extension() == kEnding ? kEnding : "";
  const std::string stem = wanted.string().substr(0, wanted.string().size() - ending.size());
  fs::path name = wanted;
  std::error_code ignored;
  for (int number = 2; fs::exists(fs::symlink_status(name, ignored)); ++number) {
    name = stem + "-" + std::to_string(number) + ending;
  }
  return name;
}

fs::path linkTarget(const fs::path& file) {
  std::error_code ignored;
  return fs::is_symlink(fs::symlink_status(file, ignored)) ? fs::weakly_canonical(file, ignored) : file;
}

fs::path numberedName(const fs::path& stem) {
  int number = 1;
  std::error_code ignored;
  while (fs::exists(fs::symlink_status(withSuffix(stem, "-" + std::to_string(number)), ignored))) {
    ++number;
  }
  return withSuffix(stem, "-" + std::to_string(number));
}

FileInTheMaking::FileInTheMaking(const fs::path& target, std::chrono::milliseconds patience)
    : path_(temporaryBeside(target)), lock_(lockNameOf(path_), patience) {
  lock_.requireHeld(target);
  removeUnfinished(path_);
}

FileInTheMaking::~FileInTheMaking() {
  if (lock_.held()) {
    removeUnfinished(path_);
  }
}

void sweepUnfinished(const fs::path& folder) {
  const std::string lockEnding = lockNameOf("").string();
  const std::string ending = temporaryBeside("").string() + lockEnding;
  std::vector<fs::path> unfinished;
  std::error_code unreadable;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder.empty() ? fs::path(".") : folder, unreadable)) {
    const std::string name = entry.path().string();
    if (name.ends_with(ending)) {
      unfinished.emplace_back(name.substr(0, name.size() - lockEnding.size()));
    }
  }
  for (const fs::path& file : unfinished) {
    if (const FileLock lock(lockNameOf(file)); lock.held()) {
      removeUnfinished(file);
    }
  }
}

}  // namespace torsio

#ifdef __linux__
#include <cstdio>
#include <fcntl.h>
#endif

namespace torsio {

namespace fs = std::filesystem;

namespace {

fs::path noteOf(const fs::path& record) {
  return withSuffix(record, ".restoring");
}

bool exchangedAtOnce(const fs::path& a, const fs::path& b) {
#ifdef __linux__
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
  return a == b;
#endif
}

}  // namespace

void exchangeRecord(const fs::path& ready, const fs::path& target, const fs::path& aside, ExchangeBy first) {
  std::error_code failed;
  if (first == ExchangeBy::kOneStep) {
    // Renamed before the exchange, so that the old record has its final name right after it.
    fs::rename(ready, aside);
    if (exchangedAtOnce(aside, target)) {
      return;
    }
    fs::rename(aside, ready);
  }
  if (first != ExchangeBy::kNote) {
    fs::create_hard_link(target, aside, failed);
    if (!failed) {
      fs::rename(ready, target, failed);
      if (failed) {
        std::error_code ignored;
        fs::remove(aside, ignored);
        throw fs::filesystem_error("rename", ready, target, failed);
      }
      return;
    }
  }
  writeFileAtomically(noteOf(target), aside.filename().string());
  fs::rename(target, aside);
  fs::rename(ready, target, failed);
  if (failed) {
    recoverRecord(target);
    throw fs::filesystem_error("rename", ready, target, failed);
  }
  fs::remove(noteOf(target), failed);
}

void recoverRecord(const fs::path& record) {
  const fs::path note = noteOf(record);
  std::error_code ignored;
  if (!fs::is_regular_file(note, ignored)) {
    return;
  }
  const fs::path aside = record.parent_path() / fs::path(readFile(note)).filename();
  if (!fs::exists(record, ignored) && fs::is_regular_file(aside, ignored)) {
    fs::rename(aside, record);
  }
  fs::remove(note, ignored);
}

}  // namespace torsio
