// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_watchdog.h"

#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/deadline.h"

namespace torsio {

ServoWatchdog::ServoWatchdog(std::function<void()> dropForce) : dropForce_(std::move(dropForce)) {
  TORSIO_EXPECTS(static_cast<bool>(dropForce_));
}

ServoWatchdog::~ServoWatchdog() {
  stop();
}

void ServoWatchdog::check(std::int64_t now_ns) noexcept {
  const std::int64_t beat_ns = lastBeat_ns_.load(std::memory_order_relaxed);
  if (beat_ns == kNever || beat_ns == stalledSince_ns_ || now_ns - beat_ns < kStall_ns) {
    return;
  }
  stalledSince_ns_ = beat_ns;
  dropForce_();
  stalls_.fetch_add(1, std::memory_order_relaxed);
}

void ServoWatchdog::start() {
  TORSIO_EXPECTS(!thread_.joinable());
  stop_.store(false, std::memory_order_relaxed);
  lastBeat_ns_.store(kNever, std::memory_order_relaxed);
  thread_ = std::thread([this] { run(); });
}

void ServoWatchdog::stop() noexcept {
  stop_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) {
    thread_.join();
  }
}

void ServoWatchdog::run() noexcept {
  (void)requestRealTime(RealTimeRank::kWatchdog);
  while (!stop_.load(std::memory_order_relaxed)) {
    const std::int64_t now_ns = deadlineNow_ns();
    check(now_ns);
    sleepUntil(now_ns + kStall_ns / 5);
  }
}

}  // namespace torsio
