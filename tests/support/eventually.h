// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

namespace torsio::testing {

/// Waits until another thread or process has made `condition` true; false on timeout. A condition that was
/// true is not asked again: it may take what it looks for.
template <typename Condition>
bool eventually(const Condition& condition, std::chrono::milliseconds within = std::chrono::seconds(20)) {
  const auto until = std::chrono::steady_clock::now() + within;
  while (!condition()) {
    if (std::chrono::steady_clock::now() >= until) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  return true;
}

}  // namespace torsio::testing
