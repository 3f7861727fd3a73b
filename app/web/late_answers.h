// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "app/web/web_sessions.h"

namespace torsio::web {

/// Answers to wrong passwords that are kept back while others wait to have theirs checked: whoever guesses
/// without a pause would else keep a right password from the same address waiting. No thread waits with them.
/// Thread-safe.
class LateAnswers {
 public:
  /// Returns how long an answer is kept back while `waiting` other guesses wait; none for one or two.
  [[nodiscard]] static std::chrono::milliseconds delayFor(std::size_t waiting) noexcept;

  /// Keeps an answer back until `due`; after end() it is given at once. `give` must not throw.
  void keep(SteadyTime due, std::function<void()> give);
  /// Gives the answers that are due.
  void tick(SteadyTime now);
  /// Gives all answers, and keeps none from now on.
  void end();

 private:
  std::mutex mutex_;
  std::vector<std::pair<SteadyTime, std::function<void()>>> kept_;
  bool ended_ = false;
};

}  // namespace torsio::web
