// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace torsio {

/// Zeroed numbers that start on a 64-byte boundary, as the kernels want them.
template <typename T>
class KernelBuffer {
  static_assert(std::is_arithmetic_v<T>);

 public:
  KernelBuffer() = default;
  /// Makes a buffer of `count` numbers. `lead`: numbers left free in front, a multiple of 64 bytes, which
  /// staggers the starts of several buffers, so that they do not meet in the same lines of the first-level
  /// cache.
  explicit KernelBuffer(std::size_t count, std::size_t lead = 0)
      : memory_(new (std::align_val_t{kAlignment}) T[count + lead]()), lead_(lead), size_(count) {}

  [[nodiscard]] T* data() noexcept { return memory_.get() + lead_; }
  [[nodiscard]] const T* data() const noexcept { return memory_.get() + lead_; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] T& operator[](std::size_t i) noexcept { return data()[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return data()[i]; }

 private:
  static constexpr std::size_t kAlignment = 64;
  struct Free {
    void operator()(T* memory) const noexcept { ::operator delete[](memory, std::align_val_t{kAlignment}); }
  };
  std::unique_ptr<T[], Free> memory_;
  std::size_t lead_ = 0;
  std::size_t size_ = 0;
};

}  // namespace torsio
