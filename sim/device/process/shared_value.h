// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>

namespace torsio {

/// The newest value of one writer for one reader in memory that two processes share. The writer never waits;
/// the reader tries a few times and else keeps what it had: a writer that died while writing holds up nobody.
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

}  // namespace torsio
