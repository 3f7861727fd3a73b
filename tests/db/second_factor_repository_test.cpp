// SPDX-License-Identifier: GPL-3.0-or-later
// One-time codes and their secret; an account whose password alone opens nothing.
#include "db/repository/people/second_factor_repository.h"

#include <string>
#include <utility>
#include <vector>

#include "db/connection/row_reader.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/people/person_data.h"
#include "sim/core/time_units.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

const char* const kWords = "the organ turns slowly";
const char* const kOtherWords = "a sentence of her own";
const UserId kAnna = "u1";
// "12345678901234567890", the key of RFC 6238, Appendix B.
const std::string kRfcSecret = "GEZDGNBVGY3TQOJQGEZDGNBVGY3TQOJQ";

TEST(OneTimeCode, AgreesWithTheVectorsOfRfc6238) {
  // Appendix B, SHA-1; of its eight digits the last six.
  for (const auto& [time_s, code] :
       std::vector<std::pair<std::int64_t, std::string>>{{59, "287082"},
                                                         {1111111109, "081804"},
                                                         {1111111111, "050471"},
                                                         {1234567890, "005924"},
                                                         {2000000000, "279037"},
                                                         {20000000000, "353130"}}) {
    EXPECT_EQ(oneTimeCode(kRfcSecret, codeStepAt(time_s * kSecond_us)), code) << time_s;
  }
}

TEST(OneTimeCode, AcceptsAClockThatIsOneStepOffAndNoMore) {
  const std::int64_t now_us = 1111111111 * kSecond_us;
  const std::int64_t now = codeStepAt(now_us);
  for (const std::int64_t off : {-2, -1, 0, 1, 2}) {
    const auto step = stepOfCode(kRfcSecret, oneTimeCode(kRfcSecret, now + off), now_us);
    EXPECT_EQ(step.has_value(), off >= -1 && off <= 1) << off;
    EXPECT_EQ(step.value_or(now + off), now + off);
  }
  EXPECT_FALSE(stepOfCode(kRfcSecret, "", now_us));
  EXPECT_FALSE(stepOfCode(kRfcSecret, "05047", now_us));
  EXPECT_FALSE(stepOfCode(kRfcSecret, "0504710", now_us));
}

TEST(OneTimeCode, ASecretIsFreshAndInBase32) {
  const std::string secret = newCodeSecret();
  EXPECT_TRUE(isCodeSecret(secret)) << secret;
  EXPECT_NE(secret, newCodeSecret());
  for (const std::string& other :
       {std::string(), secret.substr(1), secret + "A", "1" + secret.substr(1), "a" + secret.substr(1)}) {
    EXPECT_FALSE(isCodeSecret(other)) << other;
  }
}

TEST(OneTimeCode, OnlyThePasswordOfItsAccountOpensASealedSecret) {
  const std::string sealed = sealedCodeSecret(kRfcSecret, kWords, kAnna, PasswordCost::kTest);

  EXPECT_EQ(sealed.find(kRfcSecret), std::string::npos);
  EXPECT_NE(sealed, sealedCodeSecret(kRfcSecret, kWords, kAnna, PasswordCost::kTest)) << "salt and nonce";
  EXPECT_EQ(openedCodeSecret(sealed, kWords, kAnna), kRfcSecret);
  EXPECT_EQ(openedCodeSecret(sealed, kOtherWords, kAnna), "");
  EXPECT_EQ(openedCodeSecret(sealed, kWords, "u2"), "") << "copied into another account";
  for (std::size_t i = sealed.rfind('$') + 1; i < sealed.size(); i += 7) {
    std::string damaged = sealed;
    damaged[i] = damaged[i] == 'A' ? 'B' : 'A';
    EXPECT_EQ(openedCodeSecret(damaged, kWords, kAnna), "") << i;
  }
  EXPECT_EQ(openedCodeSecret("", kWords, kAnna), "");
  EXPECT_EQ(openedCodeSecret("$argon2id$v=19$m=8,t=1,p=1$AAAA$AAAA", kWords, kAnna), "");
}

class SecondFactorTest : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    AccessRepository access = repository();
    access.addUser({.id = kAnna, .login = "anna", .createdUtc_us = kSampleTime_us, .roles = {"rater"}},
                   kWords);
    access.setPassword(kAnna, access.sealPassword("anna", kWords), false);
    factors().add(kAnna, sealedCodeSecret(kRfcSecret, kWords, kAnna, PasswordCost::kTest), 0,
                  std::vector<std::string>{"abcd-efgh-jkmn-pqrs", "2345-6789-abcd-efgh"}, kSampleTime_us);
  }
  AccessRepository repository() { return AccessRepository(connection(), PasswordCost::kTest); }
  SecondFactorRepository factors() { return SecondFactorRepository(connection()); }
  SignIn tried(const std::string& code, std::int64_t at_us = kSampleTime_us) {
    return repository().signIn("anna", kWords, at_us, "here", code).outcome;
  }
  static std::string codeAt(std::int64_t at_us) { return oneTimeCode(kRfcSecret, codeStepAt(at_us)); }
};

TEST_F(SecondFactorTest, ThePasswordAloneOpensNothing) {
  EXPECT_EQ(tried(""), SignIn::kCodeNeeded);
  EXPECT_EQ(tried("000000"), SignIn::kCodeWrong);

  const SignInResult result =
      repository().signIn("anna", kWords, kSampleTime_us, "here", codeAt(kSampleTime_us));

  EXPECT_EQ(result.outcome, SignIn::kOk);
  EXPECT_TRUE(result.hasSecondFactor);
  EXPECT_FALSE(result.byRecoveryCode);
  EXPECT_EQ(repository().signIn("anna", "guess", kSampleTime_us, "here", codeAt(kSampleTime_us)).outcome,
            SignIn::kWrong)
      << "a right code says nothing about a wrong password";
}

TEST_F(SecondFactorTest, ACodeIsAcceptedOnce) {
  const std::string code = codeAt(kSampleTime_us);
  EXPECT_EQ(tried(code.substr(0, 3) + " " + code.substr(3)), SignIn::kOk);

  EXPECT_EQ(tried(code), SignIn::kCodeWrong);
  EXPECT_EQ(tried(codeAt(kSampleTime_us - 30 * kSecond_us)), SignIn::kCodeWrong) << "older than a used one";
  EXPECT_EQ(tried(codeAt(kSampleTime_us + 30 * kSecond_us)), SignIn::kOk);
  EXPECT_FALSE(factors().useStep(kAnna, codeStepAt(kSampleTime_us)));
}

TEST_F(SecondFactorTest, AClockMayBeOneStepOff) {
  EXPECT_EQ(tried(codeAt(kSampleTime_us - 60 * kSecond_us)), SignIn::kCodeWrong);
  EXPECT_EQ(tried(codeAt(kSampleTime_us + 60 * kSecond_us)), SignIn::kCodeWrong);
  EXPECT_EQ(tried(codeAt(kSampleTime_us - 30 * kSecond_us)), SignIn::kOk);
  EXPECT_EQ(tried(codeAt(kSampleTime_us + 30 * kSecond_us)), SignIn::kOk);
}

TEST_F(SecondFactorTest, ARecoveryCodeSignsInOnce) {
  EXPECT_EQ(factors().find(kAnna)->recoveryCodes, 2U);
  EXPECT_EQ(tried("zzzz-efgh-jkmn-pqrs"), SignIn::kCodeWrong);

  const SignInResult result =
      repository().signIn("anna", kWords, kSampleTime_us, "here", "ABCD efgh jkmnpqrs");

  EXPECT_EQ(result.outcome, SignIn::kOk);
  EXPECT_TRUE(result.byRecoveryCode);
  EXPECT_EQ(tried("abcd-efgh-jkmn-pqrs"), SignIn::kCodeWrong);
  EXPECT_EQ(tried("2345-6789-abcd-efgh"), SignIn::kOk);
  EXPECT_EQ(factors().find(kAnna)->recoveryCodes, 0U);
}

TEST_F(SecondFactorTest, WrongCodesMakeTheAccountWaitWhereverTheyAreTyped) {
  for (int i = 0; i <= kFreeFailures; ++i) {
    EXPECT_EQ(
        repository().signIn("anna", kWords, kSampleTime_us, "place " + std::to_string(i), "000000").outcome,
        SignIn::kCodeWrong);
  }

  const SignInResult wait =
      repository().signIn("anna", kWords, kSampleTime_us, "elsewhere", codeAt(kSampleTime_us));

  EXPECT_EQ(wait.outcome, SignIn::kWait);
  EXPECT_EQ(wait.waitUntilUtc_us, kSampleTime_us + kSecond_us);
  EXPECT_EQ(repository().signInAgain("anna", kWords, kSampleTime_us, "signed in").outcome, SignIn::kOk)
      << "whoever is signed in works on";
  EXPECT_EQ(tried(codeAt(kSampleTime_us), kSampleTime_us + kSecond_us), SignIn::kOk);
  EXPECT_EQ(tried("000000", kSampleTime_us + kSecond_us), SignIn::kCodeWrong);
  EXPECT_EQ(tried("", kSampleTime_us + kSecond_us), SignIn::kCodeNeeded) << "the right one ended the count";
}

TEST_F(SecondFactorTest, ThePasswordWithoutACodeEndsNoCountOfFailures) {
  for (int i = 0; i < kFreeFailures; ++i) {
    EXPECT_EQ(repository().signIn("anna", "guess", kSampleTime_us, "here").outcome, SignIn::kWrong);
  }
  EXPECT_EQ(tried(""), SignIn::kCodeNeeded);
  EXPECT_EQ(repository().signIn("anna", "guess", kSampleTime_us, "here").outcome, SignIn::kWrong);
  EXPECT_EQ(tried(""), SignIn::kWait);
}

TEST_F(SecondFactorTest, AChangedPasswordKeepsItAndAResetRemovesIt) {
  AccessRepository access = repository();
  access.changePassword(kAnna, access.sealPassword("anna", kOtherWords),
                        sealedCodeSecret(kRfcSecret, kOtherWords, kAnna, PasswordCost::kTest));
  EXPECT_EQ(access.signIn("anna", kOtherWords, kSampleTime_us, "here").outcome, SignIn::kCodeNeeded);
  EXPECT_EQ(access.signIn("anna", kOtherWords, kSampleTime_us, "here", codeAt(kSampleTime_us)).outcome,
            SignIn::kOk);

  EXPECT_TRUE(access.setPassword(kAnna, access.sealPassword("anna", kWords), true));

  EXPECT_EQ(tried(""), SignIn::kMustChange);
  EXPECT_FALSE(factors().find(kAnna));
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM second_factor_secret"), 0);
  EXPECT_FALSE(access.setPassword(kAnna, access.sealPassword("anna", kWords), true));
}

TEST_F(SecondFactorTest, NeitherSecretNorRecoveryCodesAreStored) {
  const auto stored = [this](const std::string& sql) {
    return selectFirst(connection(), sql, {}, readText).value_or("");
  };
  EXPECT_EQ(stored("SELECT sealed FROM second_factor_secret").find(kRfcSecret), std::string::npos);
  const std::string codes = stored("SELECT recovery_codes FROM second_factor");
  EXPECT_NE(codes, "");
  EXPECT_EQ(codes.find("abcd"), std::string::npos);
  EXPECT_EQ(codes.find("kept1$"), 0U);
}

TEST_F(SecondFactorTest, APinAsksForNoCodeAndOpensOnlyPractice) {
  AccessRepository access = repository();
  access.setPin(kAnna, access.sealPin("4711"));
  EXPECT_EQ(access.signInForPractice("anna", "4711", kSampleTime_us, "here").outcome, SignIn::kOk);
}

TEST_F(SecondFactorTest, GoesWithItsAccount) {
  EXPECT_EQ(factors().owners(), std::vector<UserId>{kAnna});
  connection().execute(
      "INSERT INTO person (id, code, state, created_utc_us, demonstration)"
      " VALUES ('p1', 'R-01', 'active', 1, FALSE)");
  connection().execute("UPDATE app_user SET person_id = 'p1' WHERE id = 'u1'");
  for (const PersonTable& table : exportPerson(connection(), "p1")) {
    EXPECT_NE(table.table, "second_factor_secret");
    if (table.table == "second_factor") {
      EXPECT_EQ(table.columns, (std::vector<std::string>{"user_id", "made_utc_us"}));
    }
  }

  erasePerson(connection(), "p1", "office", "asked for it", kSampleTime_us);

  EXPECT_TRUE(factors().owners().empty());
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM second_factor_secret"), 0);
}

}  // namespace
}  // namespace torsio
