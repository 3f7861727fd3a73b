// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace torsio {

/// Summary of a histogram. Quantiles are upper bounds: the upper edge of the bucket they fall into, but
/// never above the largest value.
struct TimingSummary {
  std::int64_t count = 0;
  double median_us = 0.0;
  double p99_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0;
};

/// Counts durations in buckets a quarter of an octave wide (at most 25 %), from 1 us to half a minute. One
/// thread adds, any thread reads; nothing allocates or locks.
class TimingHistogram {
 public:
  void add_ns(std::int64_t duration_ns) noexcept {
    const std::int64_t clipped_ns = duration_ns < 0 ? 0 : duration_ns;
    auto& bucket = buckets_[bucketOf(clipped_ns)];
    bucket.store(bucket.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    if (clipped_ns > max_ns_.load(std::memory_order_relaxed)) {
      max_ns_.store(clipped_ns, std::memory_order_relaxed);
    }
  }

  /// Calls `visit(from_us, to_us, count)` for every bucket that holds something, in order. Any thread.
  template <typename Visit>
  void forEach(const Visit& visit) const {
    for (std::size_t i = 0; i < kBuckets; ++i) {
      const std::int64_t count = buckets_[i].load(std::memory_order_relaxed);
      const double from_us = i > 0 ? static_cast<double>(edgeAfter_ns(i - 1)) * 1e-3 : 0.0;
      if (count > 0) {
        visit(from_us, static_cast<double>(edgeAfter_ns(i)) * 1e-3, count);
      }
    }
  }

  [[nodiscard]] TimingSummary summary() const noexcept {
    TimingSummary result;
    std::array<std::int64_t, kBuckets> counts{};
    for (std::size_t i = 0; i < kBuckets; ++i) {
      counts[i] = buckets_[i].load(std::memory_order_relaxed);
      result.count += counts[i];
    }
    result.max_us = static_cast<double>(max_ns_.load(std::memory_order_relaxed)) * 1e-3;
    const auto quantile_us = [&counts, &result](double share) {
      const double wanted = share * static_cast<double>(result.count);
      double seen = 0.0;
      for (std::size_t i = 0; i < kBuckets; ++i) {
        seen += static_cast<double>(counts[i]);
        if (seen >= wanted && seen > 0.0) {
          const double edge_us = static_cast<double>(edgeAfter_ns(i)) * 1e-3;
          return edge_us < result.max_us ? edge_us : result.max_us;
        }
      }
      return 0.0;
    };
    result.median_us = quantile_us(0.5);
    result.p99_us = quantile_us(0.99);
    result.p999_us = quantile_us(0.999);
    return result;
  }

 private:
  // Buckets are numbered by the exponent and the next two bits of the duration in units of 256 ns.
  static constexpr int kUnitBits = 8;
  static constexpr std::size_t kBuckets = 4 * 27;

  static std::size_t bucketOf(std::int64_t duration_ns) noexcept {
    const auto units = static_cast<std::uint64_t>(duration_ns) >> kUnitBits;
    if (units < 4) {
      return static_cast<std::size_t>(units);
    }
    const auto exponent = static_cast<std::size_t>(std::bit_width(units)) - 1;
    const auto quarter = static_cast<std::size_t>((units >> (exponent - 2)) & 3U);
    const std::size_t bucket = 4 * (exponent - 1) + quarter;
    return bucket < kBuckets ? bucket : kBuckets - 1;
  }
  static std::int64_t edgeAfter_ns(std::size_t bucket) noexcept {
    const std::size_t next = bucket + 1;
    if (next <= 4) {
      return static_cast<std::int64_t>(next) << kUnitBits;
    }
    const std::size_t exponent = next / 4 + 1;
    return static_cast<std::int64_t>((4 + next % 4) << (exponent - 2)) << kUnitBits;
  }

  std::array<std::atomic<std::int64_t>, kBuckets> buckets_{};
  std::atomic<std::int64_t> max_ns_{0};
};

}  // namespace torsio
