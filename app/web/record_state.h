// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace torsio::web {

/// Receives a line for the log. Called from several threads; may be empty.
using LogLine = std::function<void(const std::string& line)>;

/// Whether the record can be reached, shared by all threads of a desk. While it cannot, one thread at a time
/// tries again, with back-off, and the others do not wait for it. Thread-safe.
class RecordState {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `log` receives a line when the record is lost and when it is back.
  explicit RecordState(LogLine log) : log_(std::move(log)) {}

  /// True if the caller may reconnect now; it then calls failed() or reached().
  [[nodiscard]] bool mayTry(Time now);
  void failed(const std::string& cause, Time now);
  void reached(Time now);
  /// Returns whether the record could not be reached when it was last tried.
  [[nodiscard]] bool isAway();
  /// Logs the cause of a failed request, once a minute for the same cause.
  void logCause(const std::string& cause, Time now);

 private:
  void logOnce(const std::string& line, Time now);

  LogLine log_;
  std::mutex mutex_;
  bool away_ = false;
  bool trying_ = false;
  Time since_{};
  Time next_{};
  std::chrono::milliseconds pause_{};
  std::string logged_;
  Time loggedAt_{};
};

}  // namespace torsio::web
