// SPDX-License-Identifier: GPL-3.0-or-later
// Sealing requires the password and states the meaning of the signature.
#include "app/services/access/signing.h"

#include <string>

#include <gtest/gtest.h>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "assessment/domain/people/account.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/signature_repository.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

class Signing : public ::testing::Test {
 protected:
  SessionContext& signedIn() {
    EXPECT_EQ(signIn(centre_.as(""), "rater", kStudyPassword).outcome, SignIn::kOk);
    return centre_.session();
  }
  void signOne(const std::string& id) {
    SessionContext& session = centre_.session();
    session.require(Operation::kMarkSubmit);
    Transaction transaction(session.connection());
    sign(session, {.objectId = id, .reason = "seen twice"});
    transaction.commit();
    endSigning(session);
  }

  StudyCentre centre_;
};

TEST_F(Signing, AnAdministratorActingAsASimulatedPhysicianSignsOnlySimulatedObjectsWithoutAPassword) {
  addUser(centre_.as("administrator"),
          {.login = "demo", .roles = {"rater"}, .startPassword = kStudyPassword, .demonstration = true});
  const Actor physician = simulatedPerson(centre_.as("administrator"), SimulatedRole::kPhysician);
  centre_.as("").setActor(physician);
  centre_.passTime_us(3 * 60 * kMinute_us);
  SessionContext& session = centre_.session();
  EXPECT_FALSE(passwordIsDue(session));  // nobody knows one

  session.require(Operation::kMarkSubmit);
  sign(session, {.objectId = "a", .demonstration = true});
  EXPECT_THROW(sign(session, {.objectId = "b"}), Error);

  EXPECT_EQ(
      SignatureRepository(centre_.connection()).all(SignedKind::kTrainingMark).at("a").passwordShownUtc_us,
      0);
  Actor real = physician;
  real.userId = "somebody real";
  session.setActor(real);
  EXPECT_TRUE(passwordIsDue(session));
}

TEST_F(Signing, APasswordAllowsSigningForAQuarterOfAnHour) {
  signedIn();
  signOne("a");
  centre_.passTime_us(14 * kMinute_us);
  signOne("b");
  centre_.passTime_us(2 * kMinute_us);
  EXPECT_TRUE(passwordIsDue(centre_.session()));
  EXPECT_THROW(signOne("c"), PasswordDue);

  EXPECT_THROW(showPassword(centre_.session(), "something else entirely"), Error);
  EXPECT_THROW(signOne("c"), PasswordDue);
  showPassword(centre_.session(), kStudyPassword);
  signOne("c");

  const auto all = SignatureRepository(centre_.connection()).all(SignedKind::kTrainingMark);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all.at("c").meaning, SignatureMeaning::kScored);
  EXPECT_EQ(all.at("c").reason, "seen twice");
  EXPECT_EQ(all.at("c").signedUtc_us, all.at("c").passwordShownUtc_us);
  EXPECT_EQ(all.at("b").signedUtc_us - all.at("b").passwordShownUtc_us, 14 * kMinute_us);
  EXPECT_EQ(centre_.audited("signature.give"), 3);
  EXPECT_EQ(centre_.audited("user.sign_in_failed"), 1);
}

TEST_F(Signing, ACentreCanRequireThePasswordForEachSignature) {
  setCentreSetting<kSignMinutes>(centre_.as("administrator"), 0);
  signedIn();

  EXPECT_THROW(signOne("a"), PasswordDue) << "the sign-in is no signature";
  showPassword(centre_.session(), kStudyPassword);
  signOne("a");
  EXPECT_THROW(signOne("b"), PasswordDue);
  showPassword(centre_.session(), kStudyPassword);
  signOne("b");
  EXPECT_TRUE(passwordIsDue(centre_.session()));
  EXPECT_THROW(setCentreSetting<kSignMinutes>(centre_.as("administrator"), 61), Error);
}

TEST_F(Signing, AClockThatWasSetBackAllowsNoSigning) {
  signedIn();
  centre_.passTime_us(-kMinute_us);
  EXPECT_TRUE(passwordIsDue(centre_.session()));
}

TEST_F(Signing, AnAccountOfTheDemonstrationSignsOnlySimulatedObjects) {
  AccessRepository access(centre_.connection(), PasswordCost::kTest);
  access.addUser({.id = "demo", .login = "demo", .demonstration = true, .roles = {"rater"}},
                 access.sealPassword("demo", kStudyPassword));
  access.setPassword("demo", access.sealPassword("demo", kStudyPassword), false);
  ASSERT_EQ(signIn(centre_.as(""), "demo", kStudyPassword).outcome, SignIn::kOk);
  SessionContext& session = centre_.session();
  session.require(Operation::kMarkSubmit);

  EXPECT_THROW(sign(session, {.objectId = "real"}), Error);
  sign(session, {.objectId = "simulated", .demonstration = true});

  EXPECT_EQ(SignatureRepository(centre_.connection()).all(SignedKind::kTrainingMark).size(), 1U);
}

TEST_F(Signing, GuessingWhileSigningHasTheSameDelaysAsSigningIn) {
  signedIn();
  for (int i = 0; i < 4; ++i) {
    EXPECT_THROW(showPassword(centre_.session(), "guess"), Error);
  }
  const Error refused = testing::refusal([&] { showPassword(centre_.session(), kStudyPassword); });
  EXPECT_NE(refused.happened().find("too many failures"), std::string::npos) << "not even tried";
}

}  // namespace
}  // namespace torsio
