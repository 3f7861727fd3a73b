// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

#include "tests/support/fakehd/fake_record.h"

namespace fakehd {

/// A test's view of a FakeRecord: the file is created if missing. Ends the program if it cannot be mapped.
class RecordFile {
 public:
  explicit RecordFile(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0 || ftruncate(file, sizeof(FakeRecord)) != 0) {
      std::abort();
    }
    void* const place = mmap(nullptr, sizeof(FakeRecord), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    if (place == MAP_FAILED) {
      std::abort();
    }
    record_ = static_cast<FakeRecord*>(place);
  }
  ~RecordFile() { munmap(record_, sizeof(FakeRecord)); }
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  /// Returns the value of FAKEHD_RECORD in this process.
  [[nodiscard]] static std::string fromEnvironment() {
    const char* const named = std::getenv("FAKEHD_RECORD");
    return named != nullptr ? named : "/dev/null";
  }

  const FakeRecord* operator->() const noexcept { return record_; }
  [[nodiscard]] std::int64_t size() const noexcept {
    const std::int64_t most = FakeRecord::kMost;
    return record_->count < most ? record_->count.load() : most;
  }
  /// Return the first event of a kind after `after_ns`, and the last one of a kind; null: none.
  [[nodiscard]] const SeenEvent* first(Seen what, std::int64_t after_ns = 0) const noexcept {
    for (std::int64_t i = 0; i < size(); ++i) {
      const SeenEvent& event = record_->events[static_cast<std::size_t>(i)];
      if (event.time_ns > after_ns && event.what == what) {
        return &event;
      }
    }
    return nullptr;
  }
  [[nodiscard]] const SeenEvent* last(Seen what) const noexcept {
    const SeenEvent* found = nullptr;
    for (std::int64_t i = 0; i < size(); ++i) {
      const SeenEvent& event = record_->events[static_cast<std::size_t>(i)];
      found = event.time_ns > 0 && event.what == what ? &event : found;
    }
    return found;
  }

 private:
  FakeRecord* record_ = nullptr;
};

}  // namespace fakehd
