// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

namespace torsio::testing {

/// Waits until another thread or process has made `condition` true; false on timeout.
template <typename Condition>
bool eventually(const Condition& condition, std::chrono::milliseconds within = std::chrono::seconds(20)) {
  const auto until = std::chrono::steady_clock::now() + within;
  while (!condition() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  return condition();
}

}  // namespace torsio::testing
