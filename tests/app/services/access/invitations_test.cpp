// SPDX-License-Identifier: GPL-3.0-or-later
// Links for setting the first password: valid once, for a week, for one person. QR codes of links: their
// finder patterns and content.

#include "app/services/access/invitations.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/outdated_access.h"
#include "app/services/access/qr_code.h"
#include "app/services/access/two_people.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"

namespace torsio {

namespace {

constexpr const char* kChosenPassword = "seven kites above the bay";

class Invitations : public ::testing::Test {
 protected:
  UserAccount userOf(const std::string& login) {
    for (const UserAccount& user : AccessRepository(centre.connection()).users()) {
      if (user.login == login) {
        return user;
      }
    }
    return {};
  }
  std::string linkFor(const std::string& login) {
    const std::vector<UserId> ids{userOf(login).id};
    return invite(centre.as("administrator"), ids).at(0).secret;
  }
  SignIn tried(const std::string& secret, const std::string& code = {}) {
    SessionContext& session = centre.as("");
    session.setPasswordCost(PasswordCost::kTest);
    return acceptInvitation(session, secret, code, kChosenPassword).outcome;
  }
  SignIn signedIn(const std::string& login, const std::string& password) {
    return signIn(centre.as(""), login, password).outcome;
  }
  void askForTwo() {
    SettingRepository(centre.connection()).set(kTwoPeople.name, "yes", 0);
    AccessRepository access(centre.connection(), PasswordCost::kTest);
    access.addUser({.id = "u-second", .login = "second", .roles = {"administrator"}}, kStudyPassword);
    access.setPassword("u-second", access.sealPassword("second", kStudyPassword), false);
  }
  SessionContext& asSecond() {
    EXPECT_EQ(signedIn("second", kStudyPassword), SignIn::kOk);
    return centre.session();
  }

  StudyCentre centre;
};

TEST_F(Invitations, SetAPasswordOnceAndSignIn) {
  const std::string secret = linkFor("rater");
  EXPECT_EQ(secret.size(), 23U) << "twenty characters in four groups";

  EXPECT_EQ(tried(secret), SignIn::kOk);
  EXPECT_EQ(centre.session().actor().login, "rater");
  EXPECT_EQ(signedIn("rater", kChosenPassword), SignIn::kOk);
  EXPECT_EQ(signedIn("rater", kStudyPassword), SignIn::kWrong);
  EXPECT_EQ(tried(secret), SignIn::kWrong) << "it is used up";
  EXPECT_EQ(centre.audited("invitation.make"), 1);
  EXPECT_EQ(centre.audited("invitation.use"), 1);
}

TEST_F(Invitations, AWeakPasswordDoesNotUseUpTheLink) {
  const std::string secret = linkFor("rater");

  EXPECT_THROW((void)acceptInvitation(centre.as(""), secret, "", "short"), Error);
  EXPECT_THROW((void)acceptInvitation(centre.as(""), secret, "", "aaaaaaaaaaaaaaaaaa"), Error);
  EXPECT_EQ(signedIn("rater", kStudyPassword), SignIn::kOk) << "nothing has changed";
  EXPECT_EQ(tried(secret), SignIn::kOk);
}

TEST_F(Invitations, AllInvalidLinksGetTheSameAnswer) {
  const std::string replaced = linkFor("rater");
  const std::string revoked = linkFor("rater");
  const std::vector<UserId> ids{userOf("rater").id};
  EXPECT_THROW((void)revokeInvitations(centre.as("administrator"), ids, ""), Error);
  EXPECT_EQ(revokeInvitations(centre.as("administrator"), ids, "left the hospital"), 1U);
  EXPECT_EQ(revokeInvitations(centre.as("administrator"), ids, "left the hospital"), 0U);
  const std::string old = linkFor("rater");
  EXPECT_EQ(invitationsInForce(centre.as("administrator")).size(), 1U);
  centre.passTime_us(kInvitationLife_us);
  EXPECT_TRUE(invitationsInForce(centre.as("administrator")).empty());

  for (const std::string& secret : {replaced, revoked, old, std::string(), std::string("abcde-abcde")}) {
    EXPECT_EQ(tried(secret), SignIn::kWrong) << secret;
  }
  EXPECT_EQ(centre.audited("user.sign_in_failed"), 5);
  EXPECT_EQ(signedIn("rater", kStudyPassword), SignIn::kOk);
}

TEST_F(Invitations, EndWithAnotherPasswordOtherRolesOrADisabledAccount) {
  AccessRepository access(centre.connection(), PasswordCost::kTest);
  const UserId rater = userOf("rater").id;

  const std::string beforePassword = linkFor("rater");
  access.setPassword(rater, access.sealPassword("rater", kStudyPassword), false);
  EXPECT_EQ(tried(beforePassword), SignIn::kWrong);
  const std::string beforeRoles = linkFor("rater");
  access.setRoles(rater, {"rater", "allocator"});
  EXPECT_EQ(tried(beforeRoles), SignIn::kWrong) << "it was made for what the account could do then";
  const std::string beforeDisabling = linkFor("rater");
  access.setActive(rater, false);
  EXPECT_EQ(tried(beforeDisabling), SignIn::kWrong);
  const std::vector<UserId> ids{rater};
  EXPECT_THROW((void)invite(centre.as("administrator"), ids), Error) << "disabled";
  const std::vector<UserId> own{userOf("administrator").id};
  EXPECT_THROW((void)invite(centre.as("administrator"), own), Error) << "the own account";
}

TEST(InvitationWords, NameTheCentreOnlyIfItHasAName) {
  for (const std::string& centre : {std::string("Hospital A"), std::string()}) {
    for (const Text& text :
         {invitationSubject(centre), invitationWords(centre, "rater", "https://desk/join#2.abc", "noon"),
          invitationCodeWords(centre, "abcde-abcde")}) {
      const std::string words = text.str();
      EXPECT_EQ(words.find("at Hospital A") != std::string::npos, !centre.empty()) << words;
      EXPECT_EQ(words.find(" at ,"), std::string::npos) << words;
      EXPECT_EQ(words.find("  "), std::string::npos) << words;
      EXPECT_NE(words.back(), ' ') << words;
    }
  }
}

TEST_F(Invitations, OnlyOneOfTwoSimultaneousUsesSucceeds) {
  const std::string secret = linkFor("rater");
  AccessRepository access(centre.connection(), PasswordCost::kTest);
  const std::string kept =
      selectFirst(centre.connection(), "SELECT token_hash FROM invitation", {}, readText).value_or("");
  const std::string proof = hashOfSecret("torsio invitation", secret);
  // Another browser is between check and use.
  ASSERT_TRUE(access.invited(proof, centre.session().now_us()));
  EXPECT_FALSE(access.invited(kept, centre.session().now_us())) << "what the record keeps proves nothing";
  EXPECT_EQ(tried(secret), SignIn::kOk);

  EXPECT_FALSE(access.useInvitation(proof, centre.session().now_us()));
  EXPECT_EQ(signedIn("rater", kChosenPassword), SignIn::kOk);
}

TEST_F(Invitations, ThoseOfAnEarlierVersionAreNamedUntilTheyAreMadeAgain) {
  SessionContext& session = centre.as("administrator");
  EXPECT_TRUE(sentenceOf(outdatedAccess(session)).empty());
  const std::int64_t now_us = session.now_us();
  const std::string add =
      "INSERT INTO invitation (id, user_id, token_hash, made_utc_us, expires_utc_us, state)"
      " VALUES (?, ?, ?, ?, ?, 'open')";
  centre.connection().execute(add, {"old", userOf("rater").id, std::string(64, 'a'), now_us, now_us + 1000});
  centre.connection().execute(add, {"expired", userOf("trainee").id, std::string(64, 'b'), 1, now_us});

  const OutdatedAccess outdated = outdatedAccess(session);
  EXPECT_EQ(outdated.links, std::vector<UserId>{userOf("rater").id});
  EXPECT_EQ(sentenceOf(outdated).str(),
            "0 kiosk cards and 1 invitation of an earlier version open nothing any more");
  (void)linkFor("rater");
  EXPECT_TRUE(sentenceOf(outdatedAccess(session)).empty());
}

TEST_F(Invitations, NobodyInvitesAPhysicianAloneIfTwoPeopleAreRequired) {
  askForTwo();
  const UserId rater = userOf("rater").id;
  const std::vector<UserId> ids{rater};
  EXPECT_THROW((void)invite(centre.as("administrator"), ids), SecondPersonNeeded);
  const std::vector<UserId> trainee{userOf("trainee").id};
  EXPECT_EQ(invite(centre.as("administrator"), trainee).size(), 1U) << "a trainee needs one";

  const std::string code = askSecondPerson(centre.as("administrator"),
                                           {.act = DutyAct::kInvite, .subject = rater, .reason = "scores"});
  const std::string request = openRequests(centre.as("administrator")).at(0).request.id;
  EXPECT_THROW((void)confirmRequest(centre.as("administrator"), request), Error) << "the own request";
  const std::string secret = confirmRequest(asSecond(), request);

  EXPECT_EQ(tried(secret), SignIn::kWrong) << "whoever has the link alone";
  EXPECT_EQ(tried(code), SignIn::kWrong) << "or the code alone";
  EXPECT_EQ(tried(secret, code), SignIn::kOk);
  EXPECT_EQ(centre.session().actor().login, "rater");
}

TEST_F(Invitations, AreNotStoredInTheRecord) {
  const std::string secret = linkFor("rater");
  EXPECT_EQ(tried("guess-guess-guess-guess"), SignIn::kWrong);

  std::string all;
  for (const AuditEntry& entry : AuditRepository(centre.connection()).entries()) {
    all += entry.oldJson + entry.newJson + entry.reason;
  }
  for (const std::string& column :
       selectAll(centre.connection(), "SELECT id || user_id || token_hash || state FROM invitation", {},
                 [](RowReader& row) { return row.text(); })) {
    all += column;
  }
  std::string letters = secret;
  std::erase(letters, '-');
  for (const std::string& said : {secret, letters, std::string("guess")}) {
    EXPECT_EQ(all.find(said), std::string::npos);
  }
}

TEST_F(Invitations, LeadToTheAddressOfTheCentre) {
  SessionContext& session = centre.as("administrator");
  for (const char* wrong : {"desk.example.org", "http://desk.example.org", "https://", "https://a b",
                            "http://localhost.example.org", "https://desk.example.org/#x"}) {
    EXPECT_THROW(setBrowserAddress(session, wrong), Error) << wrong;
  }
  setBrowserAddress(session, "http://127.0.0.1:8443/");
  setBrowserAddress(session, "https://desk.example.org/");

  EXPECT_EQ(browserAddress(session), "https://desk.example.org");
  EXPECT_EQ(invitationLink("https://desk.example.org", "abc", false), "https://desk.example.org/join#abc");
  EXPECT_EQ(invitationLink("https://desk.example.org", "abc", true), "https://desk.example.org/join#2.abc");
}

// Trainees sign in at a kiosk with the code on their card, if the centre allows it.

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
  EXPECT_EQ(hashes[0].size(), kKeptProof.size() + 64U);
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

using Modules = std::vector<std::vector<bool>>;

/// 33 x 33, version 4: its single alignment pattern is centred at (26, 26).
constexpr std::size_t kSide = 33;

/// Returns whether a module holds no data: the three finder patterns with format bits, timing, alignment.
bool isFixed(std::size_t row, std::size_t column) {
  const bool corner =
      (row < 9 && column < 9) || (row < 9 && column >= kSide - 8) || (row >= kSide - 8 && column < 9);
  const bool alignment = row >= 24 && row <= 28 && column >= 24 && column <= 28;
  return corner || alignment || row == 6 || column == 6;
}

bool masked(int mask, std::size_t i, std::size_t j) {
  switch (mask) {
    case 0:
      return (i + j) % 2 == 0;
    case 1:
      return i % 2 == 0;
    case 2:
      return j % 3 == 0;
    case 3:
      return (i + j) % 3 == 0;
    case 4:
      return (i / 2 + j / 3) % 2 == 0;
    case 5:
      return i * j % 2 + i * j % 3 == 0;
    case 6:
      return (i * j % 2 + i * j % 3) % 2 == 0;
    default:
      return ((i + j) % 2 + i * j % 3) % 2 == 0;
  }
}

/// Returns the codewords in placement order: in pairs of columns from the right, up and down.
std::vector<unsigned> codewords(const Modules& dark) {
  int mask = 0;
  for (std::size_t column = 2; column < 5; ++column) {
    mask = 2 * mask + static_cast<int>(dark[8][column]);
  }
  mask ^= 0b101;  // XOR mask of the format bits
  std::vector<unsigned> words;
  unsigned bits = 1;
  bool up = true;
  for (int right = static_cast<int>(kSide) - 1; right > 0; right -= 2, up = !up) {
    if (right == 6) {
      --right;
    }
    for (std::size_t step = 0; step < kSide; ++step) {
      const std::size_t row = up ? kSide - 1 - step : step;
      for (const int column : {right, right - 1}) {
        const auto at = static_cast<std::size_t>(column);
        if (isFixed(row, at)) {
          continue;
        }
        bits = 2 * bits + static_cast<unsigned>(dark[row][at] != masked(mask, row, at));
        if (bits >= 0x100) {
          words.push_back(bits & 0xFF);
          bits = 1;
        }
      }
    }
  }
  return words;
}

/// Decodes byte mode of version 4-M: two interleaved blocks of 32 data codewords; four bits of mode, eight of
/// length.
std::string read(const Modules& dark) {
  const std::vector<unsigned> laid = codewords(dark);
  std::vector<unsigned> words;
  for (std::size_t block = 0; block < 2; ++block) {
    for (std::size_t i = 0; i < 32; ++i) {
      words.push_back(laid[2 * i + block]);
    }
  }
  const auto byte = [&words](std::size_t i) { return ((words[i] & 0x0F) << 4) | (words[i + 1] >> 4); };
  EXPECT_EQ(words[0] >> 4, 4U) << "bytes";
  std::string text;
  for (std::size_t i = 1; i <= byte(0); ++i) {
    text += static_cast<char>(byte(i));
  }
  return text;
}

TEST(QrCode, ContainsTheLinkOfAnInvitation) {
  const std::string link = "https://desk.example.org/join#7KQ2M-9XWPT-4HVRD-E3NYB";

  const Modules dark = qrCode(link).dark;

  ASSERT_EQ(dark.size(), kSide);
  for (const auto& row : dark) {
    ASSERT_EQ(row.size(), kSide);
  }
  // Ring, white ring, core, in three corners.
  for (const auto& [top, left] :
       {std::pair<std::size_t, std::size_t>{0, 0}, {0, kSide - 7}, {kSide - 7, 0}}) {
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_TRUE(dark[top][left + i] && dark[top + 6][left + i] && dark[top + i][left] &&
                  dark[top + i][left + 6]);
    }
    EXPECT_FALSE(dark[top + 1][left + 1]);
    EXPECT_TRUE(dark[top + 3][left + 3]);
  }
  EXPECT_EQ(read(dark), link);
}

TEST(QrCode, RejectsMoreThanACodeHolds) {
  EXPECT_EQ(qrCode(std::string(2331, '\xff')).dark.size(), 177U);
  EXPECT_THROW((void)qrCode(std::string(2332, '\xff')), Error);
}

}  // namespace

}  // namespace torsio
