// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/file_lock.h"

#include <system_error>
#include <thread>
#include <utility>

#ifndef _WIN32
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

FileLock::FileLock(fs::path file, std::chrono::milliseconds patience)
    : file_(std::move(file)), state_(take()) {
  constexpr auto kPause = std::chrono::milliseconds(20);
  for (const auto begun = std::chrono::steady_clock::now();
       state_ == State::kOthers && std::chrono::steady_clock::now() - begun < patience; state_ = take()) {
    std::this_thread::sleep_for(kPause);
  }
}

#ifdef _WIN32

// Without locks: who is faster wins.
FileLock::State FileLock::take() {
  return State::kHeld;
}

FileLock::~FileLock() = default;

#else

FileLock::State FileLock::take() {
  for (;;) {
    descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (descriptor_ < 0) {
      return State::kUnwritable;
    }
    const bool taken = flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    if (!taken && errno == EWOULDBLOCK) {
      close(std::exchange(descriptor_, -1));
      return State::kOthers;
    }
    // The former owner may have removed the file between the two calls: then this lock protects no file.
    struct stat locked {};
    struct stat named {};
    if (!taken || (fstat(descriptor_, &locked) == 0 && stat(file_.c_str(), &named) == 0 &&
                   locked.st_ino == named.st_ino && locked.st_dev == named.st_dev)) {
      return State::kHeld;  // a file system without locks excludes nothing
    }
    close(std::exchange(descriptor_, -1));
  }
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) {
    unlink(file_.c_str());
    close(descriptor_);
  }
}

#endif

void FileLock::requireHeld(const fs::path& target) const {
  if (state_ == State::kOthers) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("another program is writing this file now"),
                target.string(), Text::tr("Wait until it has come to its end"));
  }
  if (state_ == State::kUnwritable) {
    refuseUnwritable(target);
  }
}

fs::path lockNameOf(const fs::path& unfinished) {
  fs::path lock = unfinished;
  lock += ".lock";
  return lock;
}

namespace {

/// A new file would take the place of /dev/null as of any other.
const fs::path& orderlyTarget(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status there = fs::status(file, ignored);
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    throw Error(ErrorCode::kFileUnwritable,
                Text::tr("is a folder, a device or a pipe, which is never overwritten"), file.string(),
                Text::tr("Name another file"));
  }
  requireNoDatabase(file);
  return file;
}

}  // namespace

PartFile::PartFile(const fs::path& file)
    : file_(orderlyTarget(file)), path_(temporaryBeside(file)), lock_(lockNameOf(path_)) {
  lock_.requireHeld(file_);
}

PartFile::~PartFile() {
  if (lock_.held()) {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
}

void PartFile::finish() {
  std::error_code failed;
  fs::rename(path_, file_, failed);
  if (failed) {
    refuseUnwritable(file_);
  }
}

}  // namespace torsio
