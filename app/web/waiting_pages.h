// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "app/web/web_sessions.h"

namespace torsio::web {

/// Requests of pages that wait for news, held without a thread each: run again at news, and when their time
/// is over. Thread-safe.
class WaitingPages {
 public:
  using Again = std::function<void()>;

  /// Counts news; read it before the record.
  [[nodiscard]] std::uint64_t news();
  /// Holds a request until news later than `seen`, or until `until`. False: there is some already, or end()
  /// was called.
  [[nodiscard]] bool hold(std::uint64_t seen, SteadyTime until, Again again);
  [[nodiscard]] bool empty() { return size() == 0; }
  [[nodiscard]] std::size_t size();
  /// Runs all requests again.
  void tell();
  /// Runs those whose time is over.
  void tick(SteadyTime now);
  /// Runs all requests again and holds none any more.
  void end();

 private:
  struct Held {
    SteadyTime until;
    Again again;
  };
  void runAgain(const std::function<bool(const Held&)>& which, bool ends);

  std::mutex mutex_;
  std::uint64_t news_ = 0;
  bool ended_ = false;
  std::vector<Held> held_;
};

}  // namespace torsio::web
