// SPDX-License-Identifier: GPL-3.0-or-later
// Trainees sign in at a kiosk with the code on their card, if the centre allows it.
#include "app/services/access/kiosk_codes.h"

#include <gtest/gtest.h>

#include "app/services/access/centre_settings.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using testing::StudyCentre;

class KioskCodes : public ::testing::Test {
 protected:
  UserId userOf(const std::string& login) {
    for (const UserAccount& user : users(centre.as("administrator"))) {
      if (user.login == login) {
        return user.id;
      }
    }
    return {};
  }
  void allow(bool allowed) { setCentreSetting<kKioskCodes>(centre.as("administrator"), allowed); }
  std::string cardOf(const std::string& login) {
    const std::vector<UserId> ids{userOf(login)};
    return makeKioskCodes(centre.as("administrator"), ids).at(0).code;
  }
  SignIn tried(const std::string& code) { return signInWithCode(centre.as(""), code).outcome; }

  StudyCentre centre;
};

TEST_F(KioskCodes, SignInATraineeWithTheirOwnAccount) {
  allow(true);
  const std::string code = cardOf("trainee");

  SessionContext& session = centre.as("");
  EXPECT_EQ(code.size(), 20U);
  EXPECT_EQ(code.find_first_not_of("0123456789"), std::string::npos) << "the same on every keyboard";
  std::string spaced = code;
  EXPECT_EQ(signInWithCode(session, spaced.insert(4, " ").insert(9, "-")).outcome, SignIn::kOk);
  EXPECT_EQ(session.actor().login, "trainee");
  EXPECT_TRUE(session.may(Operation::kTrialRecordOwn));
  EXPECT_EQ(session.actor().passwordShownUtc_us, 0) << "a signature still asks for the password";
  EXPECT_EQ(centre.audited("user.sign_in_code"), 1);
  EXPECT_EQ(centre.audited("kiosk_code.make"), 1);
}

TEST_F(KioskCodes, AreOffByDefault) {
  const std::vector<UserId> ids{userOf("trainee")};
  EXPECT_FALSE(centreSetting<kKioskCodes>(centre.connection()));
  EXPECT_THROW((void)makeKioskCodes(centre.as("administrator"), ids), Error);
  allow(true);
  const std::string code = cardOf("trainee");
  allow(false);
  EXPECT_EQ(tried(code), SignIn::kDisabled);
  EXPECT_EQ(centre.audited("setting.change"), 2);
}

TEST_F(KioskCodes, AreNotStoredInTheRecord) {
  allow(true);
  const std::string code = cardOf("trainee");
  EXPECT_EQ(tried("12345678901234567890"), SignIn::kWrong);

  std::string all;
  for (const AuditEntry& entry : AuditRepository(centre.connection()).entries()) {
    all += entry.oldJson + entry.newJson + entry.reason;
  }
  const std::vector<std::string> hashes = selectAll(centre.connection(), "SELECT code_hash FROM kiosk_code",
                                                    {}, [](RowReader& row) { return row.text(); });
  ASSERT_EQ(hashes.size(), 1U);
  EXPECT_EQ(hashes[0].size(), 64U);
  EXPECT_EQ((all + hashes[0]).find(code), std::string::npos);
  EXPECT_EQ(all.find("12345678901234567890"), std::string::npos) << "not even what was typed in vain";
}

TEST_F(KioskCodes, ALostCardIsReplacedOrRevoked) {
  allow(true);
  const std::string lost = cardOf("trainee");
  const std::string next = cardOf("trainee");
  EXPECT_EQ(tried(lost), SignIn::kWrong);
  EXPECT_EQ(tried(next), SignIn::kOk);

  const std::vector<UserId> ids{userOf("trainee")};
  EXPECT_THROW((void)revokeKioskCodes(centre.as("administrator"), ids, ""), Error);
  EXPECT_EQ(kioskCodesInForce(centre.as("administrator")).size(), 1U);
  EXPECT_EQ(revokeKioskCodes(centre.as("administrator"), ids, "left"), 1U);
  EXPECT_EQ(revokeKioskCodes(centre.as("administrator"), ids, "left"), 0U);
  EXPECT_TRUE(kioskCodesInForce(centre.as("administrator")).empty());
  EXPECT_EQ(tried(next), SignIn::kWrong);
  EXPECT_EQ(centre.audited("kiosk_code.revoke"), 1);
}

TEST_F(KioskCodes, OpenNothingForAnotherRole) {
  allow(true);
  const std::vector<UserId> rater{userOf("rater")};
  EXPECT_THROW((void)makeKioskCodes(centre.as("administrator"), rater), Error);
  const std::string code = cardOf("trainee");
  AccessRepository(centre.connection()).setRoles(userOf("trainee"), {"trainee", "administrator"});
  EXPECT_EQ(tried(code), SignIn::kWrong) << "the card was made before the role was given";
}

TEST_F(KioskCodes, TooManyFailuresMakeTheStationWait) {
  allow(true);
  const std::string code = cardOf("trainee");
  for (std::int64_t i = 0; i <= kFreeFailures; ++i) {
    EXPECT_EQ(tried("1"), SignIn::kWrong);
  }
  EXPECT_EQ(tried(code), SignIn::kWait) << "the right card neither";
  centre.passTime_us(kLongestWait_us);
  EXPECT_EQ(tried(code), SignIn::kOk);
  EXPECT_EQ(tried("1"), SignIn::kWrong) << "and the count begins anew";
  AccessRepository(centre.connection()).setActive(userOf("trainee"), false);
  EXPECT_EQ(tried(code), SignIn::kDisabled);
}

}  // namespace
}  // namespace torsio
