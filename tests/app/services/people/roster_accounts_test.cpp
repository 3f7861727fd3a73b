// SPDX-License-Identifier: GPL-3.0-or-later
// Start passwords in halves: who has which, of whom, and what waits for the second administrator.
#include "app/services/people/roster_accounts.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/waiting_requests.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/system/setting_repository.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

/// A centre that requires two people, with a second administrator "second".
class StartPasswords : public ::testing::Test {
 protected:
  StartPasswords() {
    SettingRepository(centre_.connection()).set(kTwoPeople.name, "yes", 0);
    AccessRepository access(centre_.connection(), PasswordCost::kTest);
    access.addUser({.id = "u-second", .login = "second", .roles = {"administrator"}}, kStudyPassword);
  }
  SessionContext& asFirst() {
    centre_.as("administrator");
    return centre_.session();
  }
  SessionContext& asSecond() {
    centre_.as("second");
    return centre_.session();
  }
  StudyCentre centre_;
};

TEST_F(StartPasswords, InBulkSayWhatIsHalfAndWhoseOtherHalfItIs) {
  std::vector<PersonId> everybody = centre_.addTrainees(1);
  for (const RaterId& chief : centre_.addChiefs(2)) {
    everybody.push_back(chief);
  }
  std::vector<StartAccount> first;
  addAccounts(asFirst(), everybody, first);

  ASSERT_EQ(first.size(), 3U);  // by code, T-01
  EXPECT_EQ(first[0].part, PasswordPart::kFirstHalf);
  EXPECT_EQ(first[2].part, PasswordPart::kWhole);
  EXPECT_EQ(writtenPassword(first[0]), first[0].startPassword + "-\u2026");
  EXPECT_EQ(partWords(first[0]), "first half; the second comes from the administrator who confirms");
  EXPECT_EQ(cardWords(first[0]), "First half. The second half comes from another administrator.");
  EXPECT_TRUE(handOverWords(first).str().starts_with("2 of these 3 start passwords are only the first half."))
      << handOverWords(first);

  std::vector<StartAccount> second;
  confirmAccounts(asSecond(), openRequests(asSecond()), second);

  ASSERT_EQ(second.size(), 2U);
  std::sort(second.begin(),
            second.end(),  // the centre's clock stands still, so they were asked for at one time
            [](const StartAccount& a, const StartAccount& b) { return a.login < b.login; });
  EXPECT_EQ(second[0].part, PasswordPart::kSecondHalf);
  EXPECT_EQ(second[0].personCode, "R-01");
  EXPECT_EQ(second[0].personName, "Chief 1") << "the second administrator's cards have names, too";
  EXPECT_EQ(second[0].askedBy, "administrator");
  EXPECT_EQ(writtenPassword(second[0]), "\u2026-" + second[0].startPassword);
  EXPECT_EQ(cardWords(second[0]), "Second half. The first half comes from administrator.");
  EXPECT_NE(handOverWords(second).str().find("The first halves come from administrator, who asked"),
            std::string::npos);
  EXPECT_NE(handOverWords(second[0]).str().find("r-01 (Chief 1)"), std::string::npos);
  SessionContext& nobody = centre_.as("");
  EXPECT_EQ(signIn(nobody, "r-01", first[0].startPassword).outcome, SignIn::kWrong);
  EXPECT_EQ(signIn(nobody, "r-01", first[0].startPassword + "-" + second[0].startPassword).outcome,
            SignIn::kMustChange);
}

TEST_F(StartPasswords, OfWholeAccountsSayNothingOfHalves) {
  std::vector<StartAccount> made;
  addAccounts(asFirst(), centre_.addTrainees(2), made);

  EXPECT_EQ(handOverWords(made).str().find("half"), std::string::npos);
  EXPECT_EQ(writtenPassword(made[0]), made[0].startPassword);
  EXPECT_EQ(envelopeWords(made[0]), "Your access to Torsio. For you alone.");
}

TEST_F(StartPasswords, WaitingRequestsAreThoseThatTheActorMayConfirm) {
  const std::vector<RaterId> chiefs = centre_.addChiefs(2);
  std::vector<StartAccount> made;
  addAccounts(asFirst(), {chiefs[0], chiefs[1]}, made);

  EXPECT_EQ(waitingRequests(asFirst()), WaitingRequests{}) << "their own";
  EXPECT_EQ(waitingRequests(asSecond()).toConfirm, 2U);
  EXPECT_EQ(toConfirmWords(2), "2 requests wait for you as the second person: Users, Requests");
  EXPECT_TRUE(toConfirmWords(0).empty());
  EXPECT_EQ(waitingRequests(centre_.as("trainee")), WaitingRequests{}) << "without a right";
  ASSERT_EQ(otherAdministrators(asFirst()).size(), 1U);
  EXPECT_EQ(otherAdministrators(asFirst())[0].login, "second");
  EXPECT_NE(waitingMailWords("", "administrator", 2).str().find("Requests that wait: 2."), std::string::npos);

  std::vector<StartAccount> halves;
  confirmAccounts(asSecond(), openRequests(asSecond()), halves);
  EXPECT_EQ(waitingRequests(asSecond()), WaitingRequests{});
}

}  // namespace
}  // namespace torsio
