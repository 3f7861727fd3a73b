// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>

namespace torsio {

/// The newest value of one writer for one reader in memory that two processes share. The writer never waits;
/// the reader tries a few times, then keeps its old value: a writer that died while writing blocks nothing.
template <typename T>
class SharedValue {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// Writer's thread.
  void publish(const T& value) noexcept {
    Words words{};
    std::memcpy(words.data(), &value, sizeof(T));
    const std::uint64_t begun = sequence_.load(std::memory_order_relaxed) + 1;
    sequence_.store(begun, std::memory_order_relaxed);
    // Who sees a new word sees that writing had begun. Without a fence, which ThreadSanitizer does not know.
    for (std::size_t i = 0; i < kWords; ++i) {
      words_[i].store(words[i], std::memory_order_release);
    }
    sequence_.store(begun + 1, std::memory_order_release);
  }
  /// Returns the newest value, empty when there is none yet or the writer was writing all the while. Any
  /// thread.
  [[nodiscard]] std::optional<T> latest() const noexcept {
    constexpr int kTries = 64;
    for (int i = 0; i < kTries; ++i) {
      const std::uint64_t before = sequence_.load(std::memory_order_acquire);
      if (before == 0 || (before & 1U) != 0) {
        continue;
      }
      Words words{};
      for (std::size_t k = 0; k < kWords; ++k) {
        words[k] = words_[k].load(std::memory_order_acquire);
      }
      if (sequence_.load(std::memory_order_relaxed) == before) {
        T value;
        std::memcpy(static_cast<void*>(&value), words.data(), sizeof(T));
        return value;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kWords = (sizeof(T) + 7) / 8;
  using Words = std::array<std::uint64_t, kWords>;

  std::atomic<std::uint64_t> sequence_{0};
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

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
