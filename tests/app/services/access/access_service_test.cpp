// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/services/access/access_service.h"

#include <string>

#include <gtest/gtest.h>

#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/idle_guard.h"
#include "app/services/access/signing.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"
#include "tests/db/test_database.h"

namespace torsio {

namespace {

constexpr const char* kStart = "a first word to begin";
constexpr const char* kOwn = "own words, long enough";

std::string trailText(Connection& connection) {
  std::string text;
  for (const AuditEntry& entry : AuditRepository(connection).entries()) {
    text += entry.actor + entry.action + entry.objectId + entry.oldJson + entry.newJson + entry.reason + "\n";
  }
  return text;
}

TEST(AccessService, AFailedSignInIsAuditedWithoutTheTypedText) {
  StudyCentre centre;

  EXPECT_EQ(signIn(centre.as(""), "rater", "my secret by mistake").outcome, SignIn::kWrong);
  EXPECT_EQ(signIn(centre.as(""), "password typed as login", "x").outcome, SignIn::kWrong);

  EXPECT_EQ(centre.audited("user.sign_in_failed"), 2);
  const std::string trail = trailText(centre.connection());
  EXPECT_EQ(trail.find("secret"), std::string::npos);
  EXPECT_EQ(trail.find("typed as login"), std::string::npos);
}

TEST(AccessService, AStartPasswordOpensNothingBeforeItIsChanged) {
  StudyCentre centre;
  addUser(centre.as("administrator"), {.login = "new", .roles = {"statistician"}, .startPassword = kStart});

  SessionContext& session = centre.as("");
  const SignInAnswer first = signIn(session, "new", kStart);

  EXPECT_EQ(first.outcome, SignIn::kMustChange);
  EXPECT_TRUE(session.actor().userId.empty());
  EXPECT_FALSE(session.may(Operation::kPersonViewCoded));
  EXPECT_THROW(changeOwnPassword(session, {"new", kStart, kStart}), Error);
  EXPECT_EQ(changeOwnPassword(session, {"new", kStart, kOwn}).outcome, SignIn::kOk);
  EXPECT_TRUE(session.may(Operation::kPersonViewCoded));
}

TEST(AccessService, APinOpensOnlyPracticeAndCannotChangeItself) {
  StudyCentre centre;
  setOwnPin(centre.as("trainee"), "4711");

  SessionContext& session = centre.as("");
  const SignInAnswer answer = signInForPractice(session, "trainee", "4711");

  EXPECT_EQ(answer.outcome, SignIn::kOk);
  EXPECT_TRUE(session.may(Operation::kPractice));
  EXPECT_FALSE(session.may(Operation::kTrialRecordOwn));
  EXPECT_THROW(setOwnPin(session, "4712"), Error);
}

TEST(AccessService, AnAdministratorCanOnlyActAsASimulatedPersonAndThisIsAudited) {
  StudyCentre centre;
  EXPECT_THROW((void)simulatedPerson(centre.as("administrator"), SimulatedRole::kTrainee),
               Error);  // real people cannot be chosen
  addUser(centre.as("administrator"),
          {.login = "demo.trainee", .roles = {"trainee"}, .startPassword = kStart, .demonstration = true});

  const Actor trainee = simulatedPerson(centre.as("administrator"), SimulatedRole::kTrainee);

  EXPECT_EQ(trainee.login, "demo.trainee");
  EXPECT_EQ(trainee.roles, std::vector<std::string>{"trainee"});
  EXPECT_EQ(trainee.passwordShownUtc_us, kNoPasswordToShow);  // signs only simulated objects
  const AuditEntry newest = AuditRepository(centre.connection()).entries({.limit = 1}).front();
  EXPECT_EQ(newest.action, "user.sign_in");
  EXPECT_EQ(newest.objectId, trainee.userId);
  EXPECT_NE(newest.actor, trainee.userId);
  EXPECT_NE(newest.reason.find("simulated trainee"), std::string::npos);
  EXPECT_THROW((void)simulatedPerson(centre.as("trainee"), SimulatedRole::kTrainee), Error);

  EXPECT_THROW((void)simulatedPerson(centre.as("administrator"), SimulatedRole::kPhysician), Error);
  addUser(centre.as("administrator"),
          {.login = "demo.physician", .roles = {"rater"}, .startPassword = kStart, .demonstration = true});
  EXPECT_EQ(simulatedPerson(centre.as("administrator"), SimulatedRole::kPhysician).login, "demo.physician");
  EXPECT_NE(AuditRepository(centre.connection()).entries({.limit = 1}).front().reason.find("physician"),
            std::string::npos);
}

TEST(AccessService, ASignInNameThatIsUnreadableOrLooksLikeAnotherIsRejected) {
  StudyCentre centre;
  const auto add = [&centre](const std::string& login) {
    return addUser(centre.as("administrator"),
                   {.login = login, .roles = {"statistician"}, .startPassword = kStart});
  };
  add("anna.oz0n");
  const std::size_t before = users(centre.as("administrator")).size();

  for (const char* alike : {"\xD0\xB0nna.oz0n",         // Cyrillic a
                            "ann\xCE\xB1.oz0n",         // Greek alpha
                            "anna.\xD6\x85z0n",         // Armenian o
                            "Anna.Oz0n", "anna.ozon",   // upper case, o for 0
                            "anna.oz\xD9\xA0n",         // Arabic 0
                            "anna.oz0n ",               // a trailing space
                            "\xEF\xBD\x81nna.oz0n"}) {  // wide a
    const Refusal refused = refusalFrom([&] { add(alike); });
    EXPECT_EQ(refused.code, ErrorCode::kBadParameter) << alike;
    EXPECT_NE(refused.text.find("looks like anna.oz0n"), std::string::npos) << refused.text;
  }
  for (const char* unseen : {"", "bob\xE2\x80\x8B",  // a zero-width space
                             "bob\xE3\x85\xA4",      // a filler
                             "\xE2\x80\xAE"
                             "bob"}) {  // changes the text direction
    EXPECT_EQ(refusalFrom([&] { add(unseen); }).code, ErrorCode::kBadParameter) << unseen;
  }
  EXPECT_EQ(refusalFrom([&] { add(std::string(65, 'b')); }).code, ErrorCode::kBadParameter);

  EXPECT_EQ(users(centre.as("administrator")).size(), before);
  add("anna.ozan");
  add("\xE5\xBC\xA0\xE4\xB8\x89");  // two Chinese characters
  EXPECT_EQ(users(centre.as("administrator")).size(), before + 2);
}

TEST(AccessService, TheLastAdministratorStays) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const std::string self = session.actor().userId;

  EXPECT_THROW(setUserActive(session, self, false, "leaves"), Error);
  EXPECT_THROW(setUserRoles(session, self, {"rater"}, "changes"), Error);
}

TEST(SettingsService, TheCentreCanBeRenamedAndBothNamesAreAudited) {
  StudyCentre centre;
  setCentreName(centre.as("administrator"), "Skills laboratory");
  setCentreName(centre.session(), "Skills centre North");
  setCentreName(centre.session(), "Skills centre North");

  EXPECT_EQ(centreSign(centre.connection()).name, "Skills centre North");
  EXPECT_EQ(centre.audited("centre.rename"), 2);
  EXPECT_NE(trailText(centre.connection()).find("Skills laboratory"), std::string::npos);
  EXPECT_THROW(setCentreName(centre.session(), ""), Error);
}

TEST(AccessService, ARevokedRightIsGoneAtOnce) {
  StudyCentre centre;
  const std::string rater = centre.as("rater").actor().userId;
  setUserActive(centre.as("administrator"), rater, false, "left the centre");

  EXPECT_FALSE(centre.as("rater").may(Operation::kPractice));
  EXPECT_EQ(centre.audited("user.disable"), 1);
}

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
            "Distance from the other raters' mean that calls for a discrepancy review: 1.5 points\n"
            "Raters see the panel's marks only after all their own sheets of the occasion: yes\n");
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
