// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_callback.h"

#include "sim/servo/deadline.h"

namespace torsio {

ServoCallback::ServoCallback(ServoLoop& loop) : ServoCallback(loop, &deadlineNow_ns) {}

ServoCallback::ServoCallback(ServoLoop& loop, Clock clock)
    : loop_(loop),
      clock_(clock),
      period_ns_(loop.tickPeriod_us() * 1000),
      watchdog_([&loop] { loop.dropForce(); }) {}

bool ServoCallback::call() noexcept {
  if (stop_.load(std::memory_order_acquire)) return false;
  const std::int64_t now_ns = clock_();
  if (!begun_) {
    begun_ = true;
    begun_ns_ = now_ns;
    due_ns_ = now_ns;
  }
  // A scheduler's own jitter is no reason to leave out a tick: half a period early is in time.
  if (now_ns < due_ns_ - period_ns_ / 2) {
    early_.fetch_add(1, std::memory_order_relaxed);
    return true;
  }
  watchdog_.beat(now_ns);
  wakeUp_.add_ns(now_ns - due_ns_);
  loop_.tick((now_ns - begun_ns_) / 1000);
  const std::int64_t done_ns = clock_();
  duration_.add_ns(done_ns - now_ns);
  // Late by a period or more: the next tick is due a period from now, not at once.
  due_ns_ = now_ns - due_ns_ >= period_ns_ ? now_ns + period_ns_ : due_ns_ + period_ns_;
  return true;
}

}  // namespace torsio
