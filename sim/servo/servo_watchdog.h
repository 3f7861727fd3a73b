// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

namespace torsio {

/// Time after the last tick at which one that has not ended counts as stalled: the age at which the
/// governor, too, has faded a force to nothing (kStaleFadeEnds_us).
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

}  // namespace torsio
