// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace torsio {

/// Upper edges of the classes in which times between ticks and durations of ticks are counted; the last
/// class has no upper edge.
inline constexpr std::array<std::int64_t, 9> kTimingEdges_us{100,   250,   500,   900,   1'100,
                                                             1'500, 2'500, 5'000, 20'000};
using TimingClasses = std::array<std::int64_t, kTimingEdges_us.size() + 1>;

/// Returns the index of the class of a time: the first edge that is not below it.
[[nodiscard]] constexpr std::size_t timingClass(std::int64_t time_us) noexcept {
  std::size_t i = 0;
  while (i < kTimingEdges_us.size() && time_us > kTimingEdges_us[i]) {
    ++i;
  }
  return i;
}

/// Regularity of the servo: intervals, durations, rate. A plain value, filled by the servo thread.
struct TickStatistics {
  std::int64_t ticks = 0;
  std::int64_t late = 0;        ///< ticks that came later than 1.5 periods after the one before
  std::int64_t gaps = 0;        ///< ... later than kServoGap_us: the force was cut
  std::int64_t overruns = 0;    ///< ticks that took longer than kServoBudget_us
  std::int64_t longest_us = 0;  ///< between two ticks
  std::int64_t slowest_us = 0;  ///< duration of a tick
  double rate_Hz = 0.0;         ///< of the last window; 0 before the first one is over
  bool slow = false;            ///< the last window's rate was too low to render a force
  TimingClasses intervals{};
  TimingClasses durations{};
};

inline constexpr std::int64_t kServoPeriod_us = 1'000;
/// Longest pause between ticks after which the coupling goes on; after a longer one it starts anew.
inline constexpr std::int64_t kServoGap_us = 5'000;
/// Time that a callback should use at most: well under its tick.
inline constexpr std::int64_t kServoBudget_us = 500;
/// Length of the windows over which the rate is judged.
inline constexpr std::int64_t kRateWindow_us = 500'000;
/// Length of the first window: no force is rendered before it is over.
inline constexpr std::int64_t kFirstRateWindow_us = 50'000;
/// Rate below which no force is rendered (the vendor discourages 500 Hz already).
inline constexpr double kLowestRate_Hz = 800.0;

/// Fills the statistics from the beginnings and ends of ticks.
class TickMeter {
 public:
  /// Begins a tick; returns the time since the tick before, 0 for the first one.
  std::int64_t begin(std::int64_t now_us) noexcept {
    const std::int64_t interval_us = values_.ticks == 0 ? 0 : now_us - begun_us_;
    if (values_.ticks == 0) {
      window_us_ = now_us;
    }
    if (values_.ticks > 0) {
      ++values_.intervals[timingClass(interval_us)];
      if (2 * interval_us > 3 * kServoPeriod_us) {
        ++values_.late;
      }
      if (interval_us > kServoGap_us) {
        ++values_.gaps;
      }
      if (interval_us > values_.longest_us) {
        values_.longest_us = interval_us;
      }
    }
    ++values_.ticks;
    ++windowTicks_;
    begun_us_ = now_us;
    if (now_us - window_us_ >= (values_.rate_Hz > 0.0 ? kRateWindow_us : kFirstRateWindow_us)) {
      values_.rate_Hz =
          static_cast<double>(windowTicks_ - 1) * 1e6 / static_cast<double>(now_us - window_us_);
      values_.slow = values_.rate_Hz < kLowestRate_Hz;
      window_us_ = now_us;
      windowTicks_ = 1;
    }
    return interval_us;
  }
  void end(std::int64_t now_us) noexcept {
    const std::int64_t duration_us = now_us - begun_us_;
    ++values_.durations[timingClass(duration_us)];
    if (duration_us > kServoBudget_us) {
      ++values_.overruns;
    }
    if (duration_us > values_.slowest_us) {
      values_.slowest_us = duration_us;
    }
  }
  [[nodiscard]] const TickStatistics& values() const noexcept { return values_; }

 private:
  TickStatistics values_;
  std::int64_t begun_us_ = 0;
  std::int64_t window_us_ = 0;
  std::int64_t windowTicks_ = 0;
};

}  // namespace torsio
