// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace torsio {

/// A pose that took this much longer to arrive than the fastest one is late.
inline constexpr std::int64_t kLatePose_us = 50'000;

/// Converts a tracker's times to the station's clock, and counts late and missing poses. The offset between
/// the clocks is estimated from the fastest arrivals and follows drift (up to 100 us per second) and clock
/// changes. If the sender gives no times, the time of arrival is used and missing poses cannot be counted.
/// A value, one thread.
class TrackerClock {
 public:
  struct Moment {
    std::int64_t time_us = 0;  ///< by the station's clock, increasing
    std::int64_t place = 0;    ///< 0, 1, 2 ...; missing poses skip numbers
    bool late = false;
  };
  /// Adds a pose: `sent_us` by the sender's clock, `arrived_us` by the station's. Returns nothing for a
  /// duplicate time.
  [[nodiscard]] std::optional<Moment> take(std::optional<std::int64_t> sent_us, std::int64_t arrived_us);
  /// Median time between two poses of the first twenty; empty before those.
  [[nodiscard]] std::optional<std::int64_t> period_us() const noexcept { return period_us_; }
  /// Returns whether the sender sends times.
  [[nodiscard]] bool stamped() const noexcept { return lastSent_us_.has_value(); }

 private:
  void learn(std::int64_t gap_us);
  void follow(std::int64_t sent_us, std::int64_t arrived_us);

  std::vector<std::int64_t> gaps_us_;  // until the period is known
  std::optional<std::int64_t> period_us_;
  std::optional<std::int64_t> lastSent_us_;
  std::optional<std::int64_t> lastArrived_us_;
  std::int64_t lastTime_us_ = 0;
  std::int64_t place_ = -1;
  double offset_us_ = 0.0;  // station minus sender, for the quickest arrival
};

}  // namespace torsio
