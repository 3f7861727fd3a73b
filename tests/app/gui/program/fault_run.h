// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <sys/types.h>

#include "tests/app/gui/program/fault_scenarios.h"
#include "tests/support/fakehd/record_file.h"

namespace torsio::gui::testing {

/// A process with the fake library in one of the four places, with its own story. Several may run in
/// parallel.
class FaultRun {
 public:
  /// Starts the process. `place`: practice, graded, check, monitor. `folder`: for its files.
  FaultRun(const std::string& place, const FaultScenario& scenario, const std::string& folder);
  ~FaultRun();
  FaultRun(const FaultRun&) = delete;
  FaultRun& operator=(const FaultRun&) = delete;

  [[nodiscard]] const fakehd::RecordFile& record() const { return *record_; }
  [[nodiscard]] pid_t program() const { return program_; }
  /// Waits for its end, at most 60 s; afterwards, all results are available. False: it had to be killed.
  bool watch();
  /// Polls the device process: notes when it existed and whether it is gone.
  void lookAtDevice();

  [[nodiscard]] int code() const { return code_; }                 ///< exit code
  [[nodiscard]] const std::string& said() const { return said_; }  ///< everything printed
  /// Returns the time that a normal thread sleeping for a millisecond lost to the rest of the machine from
  /// the fault until the device process was gone, which estimates what the ending threads lost.
  [[nodiscard]] std::int64_t heldUp_ns() const { return heldUp_ns_; }
  [[nodiscard]] bool deviceGone() const { return gone_; }
  [[nodiscard]] std::int64_t deviceSeen_ns() const { return seen_ns_; }  ///< when it last existed

  /// Returns the time from an event until the motors had no force, ms, excluding the processor waiting time
  /// of the device process's threads; 0 if they had none, negative if it never ended.
  [[nodiscard]] double restAfter_ms(std::int64_t from_ns, std::int64_t waited_ns) const;
  /// Returns whether the motors had a force at this time.
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

/// Returns the time of the clock of the fake's events, ns.
[[nodiscard]] std::int64_t now_ns();

}  // namespace torsio::gui::testing
