// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

#include "sim/core/servo_health.h"
#include "sim/servo/servo_loop.h"
#include "sim/servo/timing_histogram.h"

namespace torsio {

/// Time after the last tick at which one that has not ended counts as stalled: beyond what a busy computer
/// delays a tick.
inline constexpr std::int64_t kStall_ns = 25'000'000;

/// Lets go of the hand when the tick stalls. The governor cannot: it runs inside the tick, so a tick that
/// hangs (in a driver's call, on a page from disk, on a debugger's stop) leaves the last force at the motors.
/// A second thread, of higher rank, therefore watches the ticks and asks the device itself to drop the force
/// (HapticDevice::dropForce). When the tick comes back, the governor sees the gap, sends zero and engages
/// anew by its ramp: the watchdog never gives a force back.
///
/// beat() and check() are the whole logic and take the time as an argument; start() adds the thread.
class ServoWatchdog {
 public:
  /// Makes a watchdog that calls `dropForce` from check(), once a stall; the function must not wait.
  explicit ServoWatchdog(std::function<void()> dropForce);
  /// Stops the watchdog.
  ~ServoWatchdog();
  ServoWatchdog(const ServoWatchdog&) = delete;
  ServoWatchdog& operator=(const ServoWatchdog&) = delete;

  /// Notes that the servo is alive. Servo thread; never waits, allocates nothing.
  void beat(std::int64_t now_ns) noexcept { lastBeat_ns_.store(now_ns, std::memory_order_relaxed); }
  /// Checks whether the servo is alive and drops the force if not. One thread; before the first beat
  /// nothing is watched.
  void check(std::int64_t now_ns) noexcept;

  /// Starts a thread that calls check() five times within kStall_ns, until stop().
  void start();
  void stop() noexcept;

  /// Returns the number of stalls since construction. Any thread.
  [[nodiscard]] std::int64_t stalls() const noexcept { return stalls_.load(std::memory_order_relaxed); }

 private:
  void run() noexcept;

  static constexpr std::int64_t kNever = -1;
  std::function<void()> dropForce_;
  std::atomic<std::int64_t> lastBeat_ns_{kNever};
  std::atomic<std::int64_t> stalls_{0};
  std::int64_t stalledSince_ns_ = kNever;  // the beat after which the force was dropped
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// What the system grants a thread that renders force.
struct RealTimeGrant {
  bool scheduling = false;  ///< its ticks go before ordinary work
  bool memory = false;      ///< its stack stays in memory
};

/// Asks the system as ServoThread does, in a thread of its own that ends at once.
[[nodiscard]] RealTimeGrant askForRealTime();

/// Calls ServoLoop::tick on absolute deadlines in a thread of its own, with real-time scheduling and locked
/// memory where the system permits them. A deadline that has passed by a whole period or more is skipped:
/// late ticks are counted (ServoLoop::lateTicks) and never caught up in a burst. A watchdog lets go of the
/// hand when a tick does not end (ServoWatchdog).
class ServoThread {
 public:
  /// Makes a thread for `loop` that does not run yet. `loop` outlives the thread and is touched by nobody
  /// else while it runs. `period_us` > 0.
  ServoThread(ServoLoop& loop, std::int64_t period_us);
  /// Stops the thread.
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Starts the thread with a tick at time 0. Not while running.
  void start();
  /// Stops the thread and returns after its last tick; the loop is free again.
  void stop() noexcept;

  /// Tells whether the system granted real-time scheduling.
  [[nodiscard]] bool realTime() const noexcept { return realTime_.load(std::memory_order_relaxed); }
  /// Tells whether the system granted to keep the servo's stack and state in memory.
  [[nodiscard]] bool memoryLocked() const noexcept { return memoryLocked_.load(std::memory_order_relaxed); }
  /// Returns the delays from each deadline to the beginning of its tick. Any thread.
  [[nodiscard]] TimingSummary wakeUp() const noexcept { return wakeUp_.summary(); }
  [[nodiscard]] const TimingHistogram& wakeUpHistogram() const noexcept { return wakeUp_; }
  /// Returns the durations of the ticks. Any thread.
  [[nodiscard]] TimingSummary duration() const noexcept { return duration_.summary(); }
  [[nodiscard]] const TimingHistogram& durationHistogram() const noexcept { return duration_; }
  /// Returns the number of deadlines that were skipped. Any thread.
  [[nodiscard]] std::int64_t skipped() const noexcept { return skipped_.load(std::memory_order_relaxed); }
  /// Returns how the machine has kept this thread's time. After stop().
  [[nodiscard]] ServoHealth health() const noexcept;
  /// Returns the number of ticks during which the watchdog had to drop the force. Any thread.
  [[nodiscard]] std::int64_t stalls() const noexcept { return watchdog_.stalls(); }

 private:
  void run() noexcept;

  ServoLoop& loop_;
  std::int64_t period_ns_;
  std::thread thread_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> realTime_{false};
  std::atomic<bool> memoryLocked_{false};
  std::atomic<std::int64_t> skipped_{0};
  TimingHistogram wakeUp_;
  TimingHistogram duration_;
  ServoWatchdog watchdog_;
};

}  // namespace torsio
