// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/clock.h"

namespace torsio {

/// After how much time without a key or the mouse; settings of the centre.
struct IdleLimits {
  std::int64_t warn_us = 240'000'000;  ///< "the screen will be locked in 60 s"
  std::int64_t lock_us = 300'000'000;  ///< later than the warning
};

enum class IdleState { kActive, kWarning, kLocked };

/// Locks a place that somebody left, never one at which a run goes on. Only says when: the shell asks state()
/// about once a second, shows the warning, covers the pages, and asks the same user's password. One thread.
class IdleGuard {
 public:
  /// `clock` is monotonic and outlives the guard. Throws Error{kBadParameter} unless 0 < warn_us < lock_us.
  explicit IdleGuard(const Clock& clock, IdleLimits limits = {});

  /// From now on; counting begins anew. Throws Error{kBadParameter} as the constructor does.
  void setLimits(IdleLimits limits);
  /// A key, the mouse, a touch, the haptic device. Does not open what is locked.
  void activity() noexcept;
  /// While a run goes on nothing is counted; afterwards counting begins anew.
  void setBusy(bool busy) noexcept;
  [[nodiscard]] bool busy() const noexcept { return busy_; }

  /// Now. Once locked it stays locked until unlock().
  [[nodiscard]] IdleState state() noexcept;
  /// Time left until the lock; 0 when locked, the whole limit while busy.
  [[nodiscard]] std::int64_t untilLock_us() noexcept;

  /// After the password was right.
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
