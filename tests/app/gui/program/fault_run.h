// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <sys/types.h>

#include "tests/app/gui/program/fault_scenarios.h"
#include "tests/support/fakehd/record_file.h"

namespace torsio::gui::testing {

/// A program with the fake library in it: one of the four places, in a process of its own with a story of its
/// own. Several may run at the same time.
class FaultRun {
 public:
  /// Starts it. `place`: practice, graded, check, monitor. `folder`: for its files.
  FaultRun(const std::string& place, const FaultScenario& scenario, const std::string& folder);
  ~FaultRun();
  FaultRun(const FaultRun&) = delete;
  FaultRun& operator=(const FaultRun&) = delete;

  [[nodiscard]] const fakehd::RecordFile& record() const { return *record_; }
  [[nodiscard]] pid_t program() const { return program_; }
  /// Watches it to its end, at most 60 s; then everything below is known. False: it had to be killed.
  bool watch();
  /// Looks once at the device process; notes when it was there and whether it is gone.
  void lookAtDevice();

  [[nodiscard]] int code() const { return code_; }                 ///< exit code
  [[nodiscard]] const std::string& said() const { return said_; }  ///< everything printed
  /// What a thread of ordinary rank that sleeps for a millisecond lost to the rest of the machine from the
  /// fault until the device process was gone: as much was lost to the threads that had to end.
  [[nodiscard]] std::int64_t heldUp_ns() const { return heldUp_ns_; }
  [[nodiscard]] bool deviceGone() const { return gone_; }
  [[nodiscard]] std::int64_t deviceSeen_ns() const {
    return seen_ns_;
  }  ///< when it was there for the last time

  /// Milliseconds from an event until the motors had nothing, without what the threads of the device process
  /// waited for a processor; 0 when they had nothing already, negative when they never got rid of it.
  [[nodiscard]] double restAfter_ms(std::int64_t from_ns, std::int64_t waited_ns) const;
  /// Whether the motors had a force at this time.
  [[nodiscard]] bool pushedAt(std::int64_t time_ns) const;

 private:
  std::unique_ptr<fakehd::RecordFile> record_;
  std::string output_;
  pid_t program_ = -1;
  int code_ = -1;
  std::string said_;
  bool gone_ = false;
  std::int64_t looked_ns_ = 0;
  std::int64_t heldUp_ns_ = 0;
  std::int64_t seen_ns_ = 0;
};

/// Nanoseconds of the clock that the fake's events are stamped with.
[[nodiscard]] std::int64_t now_ns();

}  // namespace torsio::gui::testing
