// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "sim/servo/servo_loop.h"
#include "sim/servo/servo_watchdog.h"
#include "sim/servo/timing_histogram.h"

namespace torsio {

/// Drives a ServoLoop from a scheduler that is not ours: the vendor's, which calls a function a thousand
/// times a second in a thread of its own. Hand `&ServoCallback::invoke` and the object's address to it. Each
/// call is at most one tick: calls that come early (a scheduler at a higher rate) pass without one, calls
/// that come late are one tick and are counted by the loop; nothing is caught up. A watchdog watches from the
/// first call on.
class ServoCallback {
 public:
  /// Clock of the deadlines, ns; another one for tests.
  using Clock = std::int64_t (*)() noexcept;

  /// `loop` outlives the object and is touched by nobody else between the first call and the return of
  /// stop().
  explicit ServoCallback(ServoLoop& loop);
  ServoCallback(ServoLoop& loop, Clock clock);

  /// The scheduler's function: true to be called again, false once stopped. The vendor's own constants for
  /// "continue" and "done" stay with the driver. noexcept, no allocation, no lock.
  [[nodiscard]] static bool invoke(void* self) noexcept { return static_cast<ServoCallback*>(self)->call(); }

  /// From now on every call says false and ticks no more. Any thread; does not wait for a call in progress:
  /// the scheduler is stopped by whoever started it.
  void stop() noexcept { stop_.store(true, std::memory_order_release); }

  /// From the ideal moment of a call to the call. Any thread.
  [[nodiscard]] const TimingHistogram& wakeUp() const noexcept { return wakeUp_; }
  /// Duration of the ticks. Any thread.
  [[nodiscard]] const TimingHistogram& duration() const noexcept { return duration_; }
  /// Calls that came before their tick was due. Any thread.
  [[nodiscard]] std::int64_t early() const noexcept { return early_.load(std::memory_order_relaxed); }
  [[nodiscard]] ServoWatchdog& watchdog() noexcept { return watchdog_; }

 private:
  [[nodiscard]] bool call() noexcept;

  ServoLoop& loop_;
  Clock clock_;
  std::int64_t period_ns_;
  std::int64_t begun_ns_ = 0;
  std::int64_t due_ns_ = 0;
  bool begun_ = false;
  std::atomic<bool> stop_{false};
  std::atomic<std::int64_t> early_{0};
  TimingHistogram wakeUp_;
  TimingHistogram duration_;
  ServoWatchdog watchdog_;
};

}  // namespace torsio
