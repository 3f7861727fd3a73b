// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace torsio {

/// What a thread needs from the system to keep a rate. deadline_posix.cpp on Linux and other POSIX systems,
/// deadline_portable.cpp elsewhere.

/// Returns the nanoseconds of the clock in which deadlines are given.
[[nodiscard]] std::int64_t deadlineNow_ns() noexcept;

/// Sleeps until the deadline; returns at once when it has passed.
void sleepUntil(std::int64_t deadline_ns) noexcept;

/// Which of two real-time threads runs when both want to.
enum class RealTimeRank { kServo, kWatchdog };

/// Asks for real-time scheduling of the calling thread and for exact wake-ups. False when the system does not
/// permit real-time scheduling: the thread then runs like any other.
bool requestRealTime(RealTimeRank rank = RealTimeRank::kServo) noexcept;

/// Keeps in memory what a servo thread works on, so that no tick waits for a disk: the calling thread's
/// stack, touched once, and one object. The lock ends with the life of the object, in the same thread. The
/// whole process is not locked: libraries that hand pages back to the system (the window's script engine)
/// cannot live with that.
class LockedMemory {
 public:
  LockedMemory(const void* object, std::size_t bytes) noexcept;
  ~LockedMemory();
  LockedMemory(const LockedMemory&) = delete;
  LockedMemory& operator=(const LockedMemory&) = delete;

  /// Tells whether the system permitted the lock. Without it everything works, but a tick may have to wait
  /// for a page.
  [[nodiscard]] bool locked() const noexcept { return locked_; }

 private:
  // deadline_portable.cpp locks nothing and uses none of these.
  [[maybe_unused]] const void* object_;
  [[maybe_unused]] std::size_t bytes_;
  [[maybe_unused]] const void* stack_ = nullptr;
  bool locked_ = false;
};

}  // namespace torsio
