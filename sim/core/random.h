// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <utility>

namespace torsio {

/// Mixes the bits of any counter or hash well (splitmix64, Vigna). Any thread; the same everywhere.
[[nodiscard]] constexpr std::uint64_t mixedBits(std::uint64_t x) noexcept {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31U);
}

/// Random numbers that are the same on every platform: the engine is fixed by the C++ standard, the
/// distributions are our own (those of the standard library differ between vendors). One thread.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] std::uint64_t next() { return engine_(); }
  /// Draws a uniform integer in [0, n), n >= 1, by rejection: no modulo bias.
  [[nodiscard]] std::uint64_t bounded(std::uint64_t n);
  /// Draws a uniform number in [0, 1) with 53 random bits.
  [[nodiscard]] double uniform();
  /// Draws a standard normal deviate (polar method, portable logarithm).
  [[nodiscard]] double normal();
  /// Makes a generator for one part of the work: same seed and stream, same numbers, whatever was drawn
  /// before.
  [[nodiscard]] static Random forStream(std::uint64_t seed, std::uint64_t stream);

  /// Shuffles `items` by Fisher and Yates from the back: for i = n..2 swap(i - 1, bounded(i)).
  template <typename T>
  void shuffle(std::span<T> items) {
    for (std::size_t i = items.size(); i >= 2; --i) {
      std::swap(items[i - 1], items[bounded(i)]);
    }
  }

 private:
  std::mt19937_64 engine_;
  double spare_ = 0.0;
  bool hasSpare_ = false;
};

}  // namespace torsio
