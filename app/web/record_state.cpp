// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/record_state.h"

#include <algorithm>

namespace torsio::web {

namespace {

constexpr std::chrono::milliseconds kFirstPause(250);
constexpr std::chrono::milliseconds kLongestPause(2000);
constexpr std::chrono::minutes kSameCause(1);

}  // namespace

bool RecordState::mayTry(Time now) {
  const std::lock_guard lock(mutex_);
  if (!away_) {
    return true;
  }
  if (trying_ || now < next_) {
    return false;
  }
  trying_ = true;
  return true;
}

void RecordState::failed(const std::string& cause, Time now) {
  const std::lock_guard lock(mutex_);
  if (!away_) {
    away_ = true;
    since_ = now;
    pause_ = kFirstPause;
  } else {
    pause_ = std::min(2 * pause_, kLongestPause);
  }
  trying_ = false;
  next_ = now + pause_;
  logOnce("The record cannot be reached: " + cause, now);
}

void RecordState::reached(Time now) {
  const std::lock_guard lock(mutex_);
  trying_ = false;
  if (!away_) {
    return;
  }
  away_ = false;
  logged_.clear();
  if (log_) {
    const auto away = std::chrono::duration_cast<std::chrono::seconds>(now - since_);
    log_("The record is back after " + std::to_string(away.count()) + " s");
  }
}

bool RecordState::isAway() {
  const std::lock_guard lock(mutex_);
  return away_;
}

void RecordState::logCause(const std::string& cause, Time now) {
  const std::lock_guard lock(mutex_);
  logOnce(cause, now);
}

void RecordState::logOnce(const std::string& line, Time now) {
  if (!log_ || (line == logged_ && now - loggedAt_ < kSameCause)) {
    return;
  }
  logged_ = line;
  loggedAt_ = now;
  log_(line);
}

}  // namespace torsio::web
