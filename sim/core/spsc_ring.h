// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <type_traits>

#include "sim/core/contracts.h"

namespace torsio {

/// Bounded lock-free queue from exactly one producer thread to exactly one consumer thread.
/// A full ring refuses the new element and counts it; nothing is overwritten. All memory is taken at
/// construction: push and pop neither allocate nor lock.
template <typename T>
class SpscRing {
  static_assert(std::is_trivially_copyable_v<T>, "only plain values cross threads");

 public:
  /// Makes an empty ring that holds at most `capacity` >= 1 elements.
  explicit SpscRing(std::size_t capacity) : slots_(capacity + 1), data_(std::make_unique<T[]>(capacity + 1)) {
    TORSIO_EXPECTS(capacity >= 1);
  }

  /// Appends an element. False when the ring is full: the element is refused and counted. Producer thread
  /// only.
  [[nodiscard]] bool push(const T& value) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    const std::size_t next = head + 1 == slots_ ? 0 : head + 1;
    if (next == tail_.load(std::memory_order_acquire)) {
      refused_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    data_[head] = value;
    head_.store(next, std::memory_order_release);
    return true;
  }

  /// Takes the oldest element. False when the ring is empty. Consumer thread only.
  [[nodiscard]] bool pop(T& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_.load(std::memory_order_acquire)) {
      return false;
    }
    value = data_[tail];
    tail_.store(tail + 1 == slots_ ? 0 : tail + 1, std::memory_order_release);
    return true;
  }

  /// Returns how many elements were refused since construction. Any thread.
  [[nodiscard]] std::size_t refused() const noexcept { return refused_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::size_t kCacheLine = 64;
  const std::size_t slots_;
  const std::unique_ptr<T[]> data_;
  alignas(kCacheLine) std::atomic<std::size_t> head_{0};
  alignas(kCacheLine) std::atomic<std::size_t> tail_{0};
  alignas(kCacheLine) std::atomic<std::size_t> refused_{0};
};

}  // namespace torsio
