// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/centre_settings.h"

#include <string>

#include <gtest/gtest.h>

#include "app/services/access/idle_guard.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

TEST(CentreSettings, InitialValuesAreValidAndNamesDiffer) {
  StudyCentre centre;
  centre.as("administrator");
  for (const CentreSetting* setting : kCentreSettings) {
    EXPECT_TRUE(validCentreSetting(*setting, std::string(setting->initial))) << setting->name;
    for (const CentreSetting* other : kCentreSettings) {
      EXPECT_TRUE(setting == other || setting->name != other->name) << setting->name;
    }
  }
  EXPECT_EQ(centreIdleLimits(centre.connection()).warn_us, IdleLimits{}.warn_us);
  EXPECT_EQ(centreIdleLimits(centre.connection()).lock_us, IdleLimits{}.lock_us);
}

TEST(CentreSettings, AnAdministratorSetsWhatRatersMustWatchAndEachChangeIsAudited) {
  StudyCentre centre;
  SessionContext& office = centre.as("administrator");
  setCentreSetting<kMinimumWatched_percent>(office, 50.0);
  setCentreSetting<kPlaybackSpeeds>(office, {2.0, 0.5});
  setCentreSetting<kDiscrepancy_points>(office, 1.5);
  setCentreSetting<kDiscrepancy_points>(office, 1.5);  // no change, no entry

  Connection& connection = centre.connection();
  EXPECT_DOUBLE_EQ(centreSetting<kMinimumWatched_percent>(connection), 50.0);
  EXPECT_EQ(centreSetting<kPlaybackSpeeds>(connection), (std::vector{0.5, 1.0, 2.0}));
  EXPECT_DOUBLE_EQ(centreSetting<kDiscrepancy_points>(connection), 1.5);
  EXPECT_EQ(centre.audited("setting.change"), 3);
  EXPECT_EQ(SettingRepository(connection).value("review.speeds"), "0.5,1,2");
  std::string told;
  for (const auto& [name, value] : settingsInReport(connection)) {
    told += name.str() + ": " + value.str() + "\n";
  }
  EXPECT_EQ(told,
            "Two people for passwords, roles, erasing, restoring and the allocation: no\n"
            "Share of a recording that a rater must have watched: 50 %\n"
            "Playback speeds that raters may use: 0.5,1,2\n"
            "Distance from the other raters' mean that calls for a discrepancy review: 1.5 points\n");
}

TEST(CentreSettings, InvalidValuesAreRejectedAndStoredOnesFallBackToTheDefault) {
  StudyCentre centre;
  const auto refuses = [&](const char* name, const char* value) {
    try {
      setCentreSettingNamed(centre.as("administrator"), name, value);
    } catch (const Error& error) {
      return error.code() == ErrorCode::kBadParameter;
    }
    return false;
  };
  EXPECT_TRUE(refuses("review.minimum_watched_percent", "101"));
  EXPECT_TRUE(refuses("review.minimum_watched_percent", "nan"));
  EXPECT_TRUE(refuses("review.speeds", "1,,2"));
  EXPECT_TRUE(refuses("review.speeds", ""));
  EXPECT_TRUE(refuses("review.speeds", "0.5;1"));
  EXPECT_TRUE(refuses("sign_minutes", "1.5"));
  EXPECT_TRUE(refuses("sound_at_limit", "on"));
  EXPECT_TRUE(refuses("idle_lock_minutes", "3"));  // the warning comes after four
  EXPECT_TRUE(refuses("mail_server", "mail.example.org"));
  EXPECT_TRUE(refuses("speed", "1"));
  EXPECT_EQ(centre.audited("setting.change"), 0);

  SettingRepository(centre.connection()).set("review.speeds", "fast", 0);
  EXPECT_EQ(centreSetting<kPlaybackSpeeds>(centre.connection()), std::vector{1.0});
}

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
