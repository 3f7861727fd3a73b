// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace torsio {

/// Wait-free hand-over of the newest value from one writer thread to one reader thread (triple buffer):
/// the writer never waits, the reader never sees a torn value, values in between may be skipped.
template <typename T>
class LatestValue {
  static_assert(std::is_trivially_copyable_v<T>, "only plain values cross threads");

 public:
  /// Publishes a new value. Writer thread only.
  void publish(const T& value) noexcept {
    buffers_[writing_] = value;
    const std::uint32_t previous = shared_.exchange(writing_ | kFresh, std::memory_order_acq_rel);
    writing_ = previous & kIndex;
  }

  /// Returns the newest published value, `T{}` before the first one. Reader thread only.
  [[nodiscard]] const T& latest() noexcept {
    if ((shared_.load(std::memory_order_relaxed) & kFresh) != 0) {
      const std::uint32_t previous = shared_.exchange(reading_, std::memory_order_acq_rel);
      reading_ = previous & kIndex;
    }
    return buffers_[reading_];
  }

 private:
  static constexpr std::uint32_t kIndex = 3;
  static constexpr std::uint32_t kFresh = 4;
  std::array<T, 3> buffers_{};
  std::uint32_t writing_ = 0;
  std::uint32_t reading_ = 1;
  alignas(64) std::atomic<std::uint32_t> shared_{2};
};

}  // namespace torsio
