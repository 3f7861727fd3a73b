// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/idle_guard.h"

#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace torsio {
namespace {

constexpr IdleLimits kLimits{.warn_us = 40, .lock_us = 60};

TEST(IdleGuard, WarnsThenLocksAndActivityDoesNotUnlock) {
  ManualClock clock(1000);
  IdleGuard guard(clock, kLimits);

  clock.advance_us(39);
  EXPECT_EQ(guard.state(), IdleState::kActive);
  clock.advance_us(1);
  EXPECT_EQ(guard.state(), IdleState::kWarning);
  EXPECT_EQ(guard.untilLock_us(), 20);
  clock.advance_us(20);

  EXPECT_EQ(guard.state(), IdleState::kLocked);
  guard.activity();
  EXPECT_EQ(guard.state(), IdleState::kLocked);
  guard.unlock();
  EXPECT_EQ(guard.state(), IdleState::kActive);
}

TEST(IdleGuard, ActivityRestartsTheCountdown) {
  ManualClock clock;
  IdleGuard guard(clock, kLimits);

  clock.advance_us(50);
  guard.activity();
  clock.advance_us(39);

  EXPECT_EQ(guard.state(), IdleState::kActive);
}

TEST(IdleGuard, AKeyAfterTheLimitFindsItLockedEvenIfTheStateWasNotChecked) {
  ManualClock clock;
  IdleGuard guard(clock, kLimits);

  clock.advance_us(1000);
  guard.activity();

  EXPECT_EQ(guard.state(), IdleState::kLocked);
}

TEST(IdleGuard, NeverLocksDuringARun) {
  ManualClock clock;
  IdleGuard guard(clock, kLimits);

  guard.setBusy(true);
  clock.advance_us(1'000'000);

  EXPECT_EQ(guard.state(), IdleState::kActive);
  guard.setBusy(false);
  EXPECT_EQ(guard.state(), IdleState::kActive);
  clock.advance_us(60);
  EXPECT_EQ(guard.state(), IdleState::kLocked);
}

TEST(IdleGuard, RejectsAWarningAfterTheLock) {
  ManualClock clock;
  EXPECT_THROW(IdleGuard(clock, IdleLimits{.warn_us = 60, .lock_us = 60}), Error);
}

}  // namespace
}  // namespace torsio
