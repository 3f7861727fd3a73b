// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace torsio::web {

/// How the desk is at the moment.
struct DeskGauges {
  std::size_t sessions = 0;      ///< people who are signed in
  std::size_t waitingPages = 0;  ///< requests held until there is news
  std::size_t queued = 0;        ///< requests that wait for a thread
  std::size_t passwords = 0;     ///< of them, those that wait for a password to be checked
  bool recordAnswers = false;
};

/// What a monitoring system reads of the desk: counts and times of answers by route, in the text format of
/// OpenMetrics 1.0. Routes are patterns ("GET /api/cases/*"), so nothing tells of a person. Thread-safe.
class DeskMetrics {
 public:
  /// Counts an answer. `what`: the route's pattern.
  void answered(const std::string& what, int status, std::chrono::nanoseconds took);
  /// Returns the whole text with the numbers of this process.
  [[nodiscard]] std::string text(const DeskGauges& now) const;

 private:
  static constexpr std::array<double, 8> kBounds_s{0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 1.0, 5.0};
  struct Times {
    std::array<std::uint64_t, kBounds_s.size() + 1> within{};  ///< of each bound; the last: longer
    double sum_s = 0.0;
  };

  mutable std::mutex mutex_;
  std::map<std::pair<std::string, int>, std::uint64_t> answers_;
  std::map<std::string, Times> times_;
};

}  // namespace torsio::web
