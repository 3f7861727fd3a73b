// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace torsio {

/// A pose that arrives so much later than the quickest one did is late.
inline constexpr std::int64_t kLatePose_us = 50'000;

/// Puts what a tracker sends on the clock of the station, and counts what is late or missing. The sender's
/// time, where it gives one, says when the instrument was there; how far its clock is off is learnt from the
/// quickest arrivals, and followed when it drifts (up to 100 us a second) or is set. Without it the arrival
/// counts, and what is missing is not known. A value, one thread.
class TrackerClock {
 public:
  struct Moment {
    std::int64_t time_us = 0;  ///< on the clock of the station; rises
    std::int64_t place = 0;  ///< 0, 1, 2 ... where nothing is missing; what is missing leaves its numbers out
    bool late = false;
  };
  /// Takes the next pose: `sent_us` by the sender's clock, `arrived_us` by the station's. Empty: it tells
  /// nothing new, its time has been there already.
  [[nodiscard]] std::optional<Moment> take(std::optional<std::int64_t> sent_us, std::int64_t arrived_us);
  /// Time between two poses, the middle one of the first twenty; empty before those.
  [[nodiscard]] std::optional<std::int64_t> period_us() const noexcept { return period_us_; }
  /// Whether the sender gives times.
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
  double offset_us_ = 0.0;  // station minus sender, of the quickest arrival
};

}  // namespace torsio
