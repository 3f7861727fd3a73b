// SPDX-License-Identifier: GPL-3.0-or-later
// The second factor as people meet it: set up, asked for, switched off, lost.
#include "app/services/access/second_factor.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "app/services/access/signing.h"
#include "app/services/access/two_people.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/people/second_factor_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/refusal.h"

namespace torsio {

namespace {

using testing::refusalCode;

constexpr const char* kOther = "own words, long enough";

class SecondFactorService : public ::testing::Test {
 protected:
  std::string codeNow(const std::string& secret) const {
    return oneTimeCode(secret, codeStepAt(centre_.now_us()));
  }
  /// Switches it on for the user of a role, who is signed in then.
  SecondFactorStart switchOn(const std::string& login) {
    SessionContext& session = centre_.as("");
    secret_ = offerSecondFactor(session, login).secret;
    const SecondFactorStart start = switchOnSecondFactor(
        session, {.login = login, .password = kStudyPassword, .secret = secret_, .code = codeNow(secret_)});
    centre_.passTime_us(30 * kSecond_us);
    return start;
  }
  SignInAnswer enter(const std::string& login, const std::string& code = {}) {
    return signIn(centre_.as(""), login, kStudyPassword, {}, code);
  }
  AuditEntry newest() { return AuditRepository(centre_.connection()).entries({.limit = 1}).front(); }
  UserId idOf(const std::string& login) {
    for (const UserAccount& user : AccessRepository(centre_.connection()).users()) {
      if (user.login == login) {
        return user.id;
      }
    }
    return {};
  }

  StudyCentre centre_;
  std::string secret_;
};

TEST_F(SecondFactorService, AnOfferFitsAuthenticatorApps) {
  setCentreName(centre_.as("administrator"), "City hospital: north");
  const SecondFactorOffer offer = offerSecondFactor(centre_.as(""), "anna.b");

  EXPECT_TRUE(isCodeSecret(offer.secret));
  EXPECT_EQ(offer.uri, "otpauth://totp/Torsio%20City%20hospital%3A%20north:anna.b?secret=" + offer.secret +
                           "&issuer=Torsio%20City%20hospital%3A%20north&algorithm=SHA1&digits=6&period=30");
}

TEST_F(SecondFactorService, ItsFirstCodeSwitchesItOnAndTenRecoveryCodesAreShown) {
  const SecondFactorStart start = switchOn("rater");

  EXPECT_EQ(start.answer.outcome, SignIn::kOk);
  EXPECT_EQ(centre_.session().actor().login, "rater");
  EXPECT_EQ(std::set<std::string>(start.recoveryCodes.begin(), start.recoveryCodes.end()).size(), 10U);
  EXPECT_EQ(start.recoveryCodes.front().size(), 19U);
  EXPECT_EQ(ownSecondFactor(centre_.session()).recoveryCodes, 10U);
  EXPECT_EQ(centre_.audited("user.switch_on_second_factor"), 1);
  EXPECT_EQ(enter("rater").outcome, SignIn::kCodeNeeded);
  EXPECT_TRUE(centre_.session().actor().userId.empty());
  EXPECT_EQ(enter("rater", codeNow(secret_)).outcome, SignIn::kOk);
  EXPECT_EQ(newest().newJson, R"({"second_factor":"code"})");
  EXPECT_EQ(enter("rater", start.recoveryCodes.front()).outcome, SignIn::kOk);
  EXPECT_EQ(newest().newJson, R"({"second_factor":"recovery code"})");
  EXPECT_EQ(ownSecondFactor(centre_.session()).recoveryCodes, 9U);
  EXPECT_EQ(secondFactors(centre_.as("administrator")), std::set<UserId>{idOf("rater")});
  EXPECT_TRUE(verifyAuditTrail(centre_.connection()).empty());
}

TEST_F(SecondFactorService, AWrongFirstCodeSwitchesNothingOn) {
  SessionContext& session = centre_.as("");
  SecondFactorWish wish{.login = "rater",
                        .password = kStudyPassword,
                        .secret = offerSecondFactor(session, "rater").secret,
                        .code = "000000"};
  EXPECT_EQ(refusalCode([&] { (void)switchOnSecondFactor(session, wish); }), ErrorCode::kBadParameter);
  wish.code = codeNow(wish.secret);
  wish.password = "not this one at all";
  EXPECT_EQ(refusalCode([&] { (void)switchOnSecondFactor(session, wish); }), ErrorCode::kPermission);
  wish.password = kStudyPassword;
  wish.secret = "too short";
  EXPECT_EQ(refusalCode([&] { (void)switchOnSecondFactor(session, wish); }), ErrorCode::kBadParameter);

  EXPECT_TRUE(secondFactors(centre_.as("administrator")).empty());
  (void)switchOn("rater");
  EXPECT_EQ(refusalCode([&] { (void)switchOn("rater"); }), ErrorCode::kBadData) << "it is on already";
}

TEST_F(SecondFactorService, WrongCodesAreAuditedAndAMissingOneIsNot) {
  (void)switchOn("rater");
  const std::int64_t before = centre_.audited("user.sign_in_failed");

  EXPECT_EQ(enter("rater").outcome, SignIn::kCodeNeeded);
  EXPECT_EQ(centre_.audited("user.sign_in_failed"), before);
  EXPECT_EQ(enter("rater", "000000").outcome, SignIn::kCodeWrong);

  EXPECT_EQ(centre_.audited("user.sign_in_failed"), before + 1);
  EXPECT_EQ(newest().newJson, R"({"outcome":"wrong","with":"code"})");
}

TEST_F(SecondFactorService, TheCentreAsksAdministratorsOrEverybody) {
  EXPECT_EQ(enter("administrator").outcome, SignIn::kOk) << "nobody at first";
  setCentreSetting<kSecondFactor>(centre_.as("administrator"), "administrators");
  EXPECT_EQ(enter("rater").outcome, SignIn::kOk);
  const SignInAnswer asked = enter("administrator");

  EXPECT_EQ(asked.outcome, SignIn::kMustEnrol);
  EXPECT_EQ(asked.actor.login, "administrator");
  EXPECT_TRUE(centre_.session().actor().userId.empty()) << "nobody is signed in yet";
  EXPECT_EQ(switchOn("administrator").answer.outcome, SignIn::kOk);
  EXPECT_EQ(enter("administrator").outcome, SignIn::kCodeNeeded);
  SettingRepository(centre_.connection()).set(kSecondFactor.name, "everybody", 0);
  EXPECT_EQ(enter("rater").outcome, SignIn::kMustEnrol);
  EXPECT_EQ(refusalCode([&] { setCentreSetting<kSecondFactor>(centre_.as("administrator"), "raters"); }),
            ErrorCode::kBadParameter);
}

TEST_F(SecondFactorService, AStartPasswordIsChangedFirstAndThenItIsSetUp) {
  setCentreSetting<kSecondFactor>(centre_.as("administrator"), "everybody");
  resetPassword(centre_.as("administrator"), idOf("trainee"), "a start password to know", "forgotten");
  SessionContext& session = centre_.as("");
  EXPECT_EQ(signIn(session, "trainee", "a start password to know").outcome, SignIn::kMustChange);

  const SignInAnswer changed = changeOwnPassword(session, {"trainee", "a start password to know", kOther});

  EXPECT_EQ(changed.outcome, SignIn::kMustEnrol);
  EXPECT_TRUE(session.actor().userId.empty());
  EXPECT_EQ(signIn(session, "trainee", kOther).outcome, SignIn::kMustEnrol) << "the new one is in use";
}

TEST_F(SecondFactorService, ChangingThePasswordAsksForTheCodeAndKeepsTheSecret) {
  (void)switchOn("rater");
  SessionContext& session = centre_.as("rater");
  EXPECT_EQ(refusalCode([&] {
              changeOwnPassword(session, {"rater", kStudyPassword, kOther});
            }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] {
              changeOwnPassword(session, {"rater", kStudyPassword, kOther, "000000"});
            }),
            ErrorCode::kPermission);

  EXPECT_EQ(changeOwnPassword(session, {"rater", kStudyPassword, kOther, codeNow(secret_)}).outcome,
            SignIn::kOk);

  centre_.passTime_us(30 * kSecond_us);
  EXPECT_EQ(enter("rater").outcome, SignIn::kWrong);
  EXPECT_EQ(signIn(centre_.as(""), "rater", kOther).outcome, SignIn::kCodeNeeded);
  EXPECT_EQ(signIn(centre_.as(""), "rater", kOther, {}, codeNow(secret_)).outcome, SignIn::kOk);
}

TEST_F(SecondFactorService, SigningAndTheLockAskForThePasswordAlone) {
  (void)switchOn("rater");
  centre_.passTime_us(kHour_us);
  ASSERT_TRUE(passwordIsDue(centre_.session()));
  showPassword(centre_.session(), kStudyPassword);
  EXPECT_FALSE(passwordIsDue(centre_.session()));
  EXPECT_EQ(signInAgain(centre_.session(), "rater", kStudyPassword).outcome, SignIn::kOk);
}

TEST_F(SecondFactorService, ItsOwnerSwitchesItOffWithACode) {
  const SecondFactorStart start = switchOn("rater");
  SessionContext& session = centre_.session();
  EXPECT_EQ(refusalCode([&] { switchOffSecondFactor(session, kStudyPassword, ""); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { switchOffSecondFactor(session, "not this one", codeNow(secret_)); }),
            ErrorCode::kPermission);
  EXPECT_TRUE(ownSecondFactor(session).on);

  switchOffSecondFactor(session, kStudyPassword, start.recoveryCodes.back());

  EXPECT_FALSE(ownSecondFactor(session).on);
  EXPECT_EQ(centre_.audited("user.switch_off_second_factor"), 1);
  EXPECT_EQ(enter("rater").outcome, SignIn::kOk);
  EXPECT_EQ(refusalCode([&] { switchOffSecondFactor(centre_.session(), kStudyPassword, "000000"); }),
            ErrorCode::kBadData);
  EXPECT_EQ(refusalCode([&] { switchOffSecondFactor(centre_.as(""), kStudyPassword, "000000"); }),
            ErrorCode::kPermission);
}

TEST_F(SecondFactorService, ANewStartPasswordRemovesItWithTwoPeopleWhereTheRuleIsOn) {
  (void)switchOn("rater");
  SettingRepository(centre_.connection()).set(kTwoPeople.name, "yes", 0);
  AccessRepository access(centre_.connection(), PasswordCost::kTest);
  access.addUser({.id = "u-second", .login = "second", .roles = {"administrator"}}, kStudyPassword);
  access.setPassword("u-second", access.sealPassword("second", kStudyPassword), false);
  const UserId rater = idOf("rater");
  EXPECT_THROW(resetPassword(centre_.as("administrator"), rater, "a start password to know", "phone lost"),
               SecondPersonNeeded);
  EXPECT_TRUE(SecondFactorRepository(centre_.connection()).find(rater));

  const std::string first =
      askSecondPerson(centre_.as("administrator"),
                      {.act = DutyAct::kResetPassword, .subject = rater, .reason = "phone lost"});
  EXPECT_EQ(enter("second").outcome, SignIn::kOk);
  const std::string second =
      confirmRequest(centre_.session(), openRequests(centre_.session()).at(0).request.id);

  EXPECT_FALSE(SecondFactorRepository(centre_.connection()).find(rater));
  EXPECT_EQ(signIn(centre_.as(""), "rater", first + "-" + second).outcome, SignIn::kMustChange);
  bool told = false;
  for (const AuditEntry& entry : AuditRepository(centre_.connection()).entries()) {
    told =
        told || (entry.action == "user.reset_password" && entry.newJson == R"({"second_factor":"removed"})");
  }
  EXPECT_TRUE(told);
}

TEST_F(SecondFactorService, AnInvitationRemovesIt) {
  SettingRepository(centre_.connection()).set(kTwoPeople.name, "no", 0);
  (void)switchOn("rater");
  const std::vector<UserId> ids{idOf("rater")};
  const std::string secret = invite(centre_.as("administrator"), ids).at(0).secret;

  EXPECT_EQ(acceptInvitation(centre_.as(""), secret, "", kOther).outcome, SignIn::kOk);

  EXPECT_FALSE(SecondFactorRepository(centre_.connection()).find(ids.front()));
}

TEST_F(SecondFactorService, ADamagedSecretIsPassedByARecoveryCodeAndGoesWithTheNextPassword) {
  const SecondFactorStart start = switchOn("rater");
  const UserId rater = idOf("rater");
  SecondFactorRepository(centre_.connection())
      .reseal(rater, sealedCodeSecret(secret_, "the password before", rater, PasswordCost::kTest));
  EXPECT_EQ(enter("rater", codeNow(secret_)).outcome, SignIn::kCodeWrong);

  EXPECT_EQ(changeOwnPassword(centre_.as(""), {"rater", kStudyPassword, kOther, start.recoveryCodes.front()})
                .outcome,
            SignIn::kOk);

  EXPECT_FALSE(SecondFactorRepository(centre_.connection()).find(rater));
}

}  // namespace

}  // namespace torsio
