// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/idle_guard.h"

#include <algorithm>

#include "sim/core/error.h"

namespace torsio {

IdleGuard::IdleGuard(const Clock& clock, IdleLimits limits)
    : clock_(clock), lastActivity_us_(clock.now_us()) {
  setLimits(limits);
}

void IdleGuard::setLimits(IdleLimits limits) {
  if (limits.warn_us <= 0 || limits.warn_us >= limits.lock_us) {
    refuseParameter(Text::tr("the warning must come before the lock"), Text::tr("idle lock"),
                    Text::tr("Give a warning time above 0 and below the lock time"));
  }
  limits_ = limits;
  if (!locked_) {
    lastActivity_us_ = clock_.now_us();
  }
}

std::int64_t IdleGuard::idle_us() const noexcept {
  return busy_ ? 0 : std::max<std::int64_t>(0, clock_.now_us() - lastActivity_us_);
}

void IdleGuard::activity() noexcept {
  // Also counts idle time since the last call: a key press after the limit finds the screen locked.
  if (state() != IdleState::kLocked) {
    lastActivity_us_ = clock_.now_us();
  }
}

void IdleGuard::setBusy(bool busy) noexcept {
  if (state() == IdleState::kLocked) {
    return;
  }
  busy_ = busy;
  lastActivity_us_ = clock_.now_us();
}

IdleState IdleGuard::state() noexcept {
  if (idle_us() >= limits_.lock_us) {
    locked_ = true;
  }
  if (locked_) {
    return IdleState::kLocked;
  }
  return idle_us() >= limits_.warn_us ? IdleState::kWarning : IdleState::kActive;
}

std::int64_t IdleGuard::untilLock_us() noexcept {
  return state() == IdleState::kLocked ? 0 : limits_.lock_us - idle_us();
}

void IdleGuard::unlock() noexcept {
  locked_ = false;
  lastActivity_us_ = clock_.now_us();
}

}  // namespace torsio
