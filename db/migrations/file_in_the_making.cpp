// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/file_in_the_making.h"

#include <system_error>
#include <vector>

#include <QLockFile>

#include "sim/base/error.h"
#include "sim/base/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr const char* kLock = ".lock";

/// Held by no living program: one that was killed is found by its number and its name.
std::unique_ptr<QLockFile> lockBeside(const fs::path& unfinished) {
  auto lock = std::make_unique<QLockFile>(QString::fromStdString(withSuffix(unfinished, kLock).string()));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

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

fs::path numberedName(const fs::path& stem) {
  int number = 1;
  std::error_code ignored;
  while (fs::exists(fs::symlink_status(withSuffix(stem, "-" + std::to_string(number)), ignored))) {
    ++number;
  }
  return withSuffix(stem, "-" + std::to_string(number));
}

bool takeLock(QLockFile& lock) {
  if (lock.tryLock(0)) {
    return true;
  }
  // One that names nobody goes when the system says that nobody holds it.
  qint64 process = 0;
  QString machine;
  QString program;
  return lock.error() == QLockFile::LockFailedError && !lock.getLockInfo(&process, &machine, &program) &&
         lock.removeStaleLockFile() && lock.tryLock(0);
}

FileInTheMaking::FileInTheMaking(const fs::path& target)
    : path_(temporaryBeside(target)), lock_(lockBeside(path_)) {
  if (!takeLock(*lock_)) {
    if (lock_->error() == QLockFile::LockFailedError) {
      throw Error(ErrorCode::kDatabase, Text::tr("another program is writing this file now"), target.string(),
                  Text::tr("Wait until it has come to its end"));
    }
    throw Error(ErrorCode::kFileUnwritable, Text::tr("cannot be written"), target.string(),
                Text::tr("Choose a folder in which you may write"));
  }
  removeDatabase(path_);
}

FileInTheMaking::~FileInTheMaking() {
  removeDatabase(path_);
}

void sweepUnfinished(const fs::path& folder) {
  const std::string ending = temporaryBeside("").string() + kLock;
  std::vector<fs::path> unfinished;
  std::error_code unreadable;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder.empty() ? fs::path(".") : folder, unreadable)) {
    const std::string name = entry.path().string();
    if (name.ends_with(ending)) {
      unfinished.emplace_back(name.substr(0, name.size() - std::string(kLock).size()));
    }
  }
  for (const fs::path& file : unfinished) {
    const std::unique_ptr<QLockFile> lock = lockBeside(file);
    if (takeLock(*lock)) {
      removeDatabase(file);
    }
  }
}

}  // namespace torsio
