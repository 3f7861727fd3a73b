// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/clock.h"

namespace torsio {

/// Idle times without keyboard or mouse; settings of the centre.
struct IdleLimits {
  std::int64_t warn_us = 240'000'000;  ///< "the screen will be locked in 60 s"
  std::int64_t lock_us = 300'000'000;  ///< greater than warn_us
};

enum class IdleState { kActive, kWarning, kLocked };

/// Locks an unattended station, but never during a run. Only decides when: the shell calls state() about once
/// a second, shows the warning, covers the pages and asks for the same user's password. One thread.
class IdleGuard {
 public:
  /// `clock` is monotonic and outlives the guard. Throws Error{kBadParameter} unless 0 < warn_us < lock_us.
  explicit IdleGuard(const Clock& clock, IdleLimits limits = {});

  /// Sets new limits and restarts the countdown. Throws Error{kBadParameter} like the constructor.
  void setLimits(IdleLimits limits);
  /// Reports a key press, mouse, touch or the haptic device. Does not unlock.
  void activity() noexcept;
  /// Pauses the countdown during a run; restarts it afterwards.
  void setBusy(bool busy) noexcept;
  [[nodiscard]] bool busy() const noexcept { return busy_; }

  /// Returns the current state. Once locked, it stays locked until unlock().
  [[nodiscard]] IdleState state() noexcept;
  /// Returns the time until the lock; 0 if locked, the whole limit while busy.
  [[nodiscard]] std::int64_t untilLock_us() noexcept;

  /// Call after the correct password.
  void unlock() noexcept;

 private:
  [[nodiscard]] std::int64_t idle_us() const noexcept;

  const Clock& clock_;
  IdleLimits limits_;
  std::int64_t lastActivity_us_;
  bool busy_ = false;
  bool locked_ = false;
};

}  // namespace torsio
