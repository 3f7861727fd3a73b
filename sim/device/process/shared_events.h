// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "sim/device/process/shared_value.h"

namespace torsio {

/// Events of one writer for one reader in memory that two processes share. Neither ever waits; a reader that
/// comes too late misses the oldest.
template <typename T, std::size_t Capacity>
class SharedEvents {
 public:
  /// Writer's thread.
  void publish(const T& event) noexcept {
    const std::uint64_t number = published_.load(std::memory_order_relaxed);
    slots_[number % Capacity].publish(event);
    published_.store(number + 1, std::memory_order_release);
  }
  /// Takes the event after the `taken` ones and counts it there; false when there is none. Reader's thread.
  [[nodiscard]] bool next(std::uint64_t& taken, T& event) const noexcept {
    const std::uint64_t published = published_.load(std::memory_order_acquire);
    if (published - taken > Capacity) {
      taken = published - Capacity;
    }
    while (taken < published) {
      if (const std::optional<T> found = slots_[taken++ % Capacity].latest()) {
        event = *found;
        return true;
      }
    }
    return false;
  }

 private:
  std::atomic<std::uint64_t> published_{0};
  std::array<SharedValue<T>, Capacity> slots_{};
};

}  // namespace torsio
