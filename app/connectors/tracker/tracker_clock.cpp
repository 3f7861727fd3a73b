// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/tracker/tracker_clock.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace torsio {

namespace {

constexpr std::size_t kLearnt = 20;
constexpr std::int64_t kClockWasSet_us = 1'000'000;
constexpr double kDrift = 100e-6;
constexpr double kMissingFrom = 1.5;  // periods

}  // namespace

void TrackerClock::learn(std::int64_t gap_us) {
  if (period_us_) {
    return;
  }
  gaps_us_.push_back(gap_us);
  if (gaps_us_.size() == kLearnt) {
    const auto middle = gaps_us_.begin() + kLearnt / 2;
    std::nth_element(gaps_us_.begin(), middle, gaps_us_.end());
    period_us_ = std::max<std::int64_t>(1, *middle);
  }
}

void TrackerClock::follow(std::int64_t sent_us, std::int64_t arrived_us) {
  const auto seen_us = static_cast<double>(arrived_us - sent_us);
  if (!lastSent_us_) {
    offset_us_ = seen_us;
    return;
  }
  offset_us_ += kDrift * static_cast<double>(arrived_us - *lastArrived_us_);
  offset_us_ = std::min(offset_us_, seen_us);
}

std::optional<TrackerClock::Moment> TrackerClock::take(std::optional<std::int64_t> sent_us,
                                                       std::int64_t arrived_us) {
  Moment moment{.time_us = arrived_us, .place = place_ + 1};
  if (sent_us) {
    const bool wasSet =
        lastSent_us_ && (*sent_us < *lastSent_us_ - kClockWasSet_us ||
                         static_cast<double>(arrived_us - *sent_us) < offset_us_ - kClockWasSet_us);
    if (wasSet) {
      lastSent_us_.reset();  // cannot tell what was lost in between
    }
    if (lastSent_us_ && *sent_us <= *lastSent_us_) {
      return std::nullopt;
    }
    follow(*sent_us, arrived_us);
    moment.time_us = *sent_us + std::llround(offset_us_);
    moment.late = arrived_us - moment.time_us > kLatePose_us;
    if (lastSent_us_) {
      const std::int64_t gap_us = *sent_us - *lastSent_us_;
      learn(gap_us);
      if (period_us_ && static_cast<double>(gap_us) > kMissingFrom * static_cast<double>(*period_us_)) {
        moment.place += std::llround(static_cast<double>(gap_us) / static_cast<double>(*period_us_)) - 1;
      }
    }
    lastSent_us_ = sent_us;
  } else if (lastArrived_us_) {
    const std::int64_t gap_us = arrived_us - *lastArrived_us_;
    learn(gap_us);
    moment.late = period_us_ && gap_us > *period_us_ + kLatePose_us;
  }
  if (place_ >= 0) {
    moment.time_us = std::max(moment.time_us, lastTime_us_ + 1);
  }
  lastTime_us_ = moment.time_us;
  lastArrived_us_ = arrived_us;
  place_ = moment.place;
  return moment;
}

}  // namespace torsio
