// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_thread.h"

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

RealTimeGrant askForRealTime() {
  RealTimeGrant grant;
  std::thread([&grant] {
    grant.scheduling = requestRealTime(RealTimeRank::kServo);
    grant.memory = LockedMemory(&grant, sizeof grant).locked();
  }).join();
  return grant;
}

ServoThread::ServoThread(ServoLoop& loop, std::int64_t period_us)
    : loop_(loop), period_ns_(period_us * 1000), watchdog_([&loop] { loop.dropForce(); }) {
  TORSIO_EXPECTS(period_us > 0);
}

ServoThread::~ServoThread() {
  stop();
}

void ServoThread::start() {
  TORSIO_EXPECTS(!thread_.joinable());
  stop_.store(false, std::memory_order_relaxed);
  watchdog_.start();
  thread_ = std::thread([this] { run(); });
}

void ServoThread::stop() noexcept {
  stop_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) {
    thread_.join();
  }
  watchdog_.stop();
}

ServoHealth ServoThread::health() const noexcept {
  return {realTime(), memoryLocked(), skipped(), loop_.forceCuts()};
}

void ServoThread::run() noexcept {
  realTime_.store(requestRealTime(), std::memory_order_relaxed);
  const LockedMemory memory(&loop_, sizeof(loop_));
  memoryLocked_.store(memory.locked(), std::memory_order_relaxed);
  const std::int64_t begun_ns = deadlineNow_ns();
  std::int64_t deadline_ns = begun_ns;
  while (!stop_.load(std::memory_order_relaxed)) {
    sleepUntil(deadline_ns);
    const std::int64_t awake_ns = deadlineNow_ns();
    watchdog_.beat(awake_ns);
    wakeUp_.add_ns(awake_ns - deadline_ns);
    loop_.tick((awake_ns - begun_ns) / 1000);
    const std::int64_t done_ns = deadlineNow_ns();
    duration_.add_ns(done_ns - awake_ns);

    deadline_ns += period_ns_;
    if (done_ns >= deadline_ns + period_ns_) {
      const std::int64_t missed = (done_ns - deadline_ns) / period_ns_;
      skipped_.fetch_add(missed, std::memory_order_relaxed);
      deadline_ns += missed * period_ns_;
    }
  }
}

}  // namespace torsio
