// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/access_repository.h"

#include <map>

#include "assessment/domain/people/account.h"
#include "assessment/domain/people/password_rule.h"
#include "db/connection/connection.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"
#include "tests/support/stored_rows.h"

namespace torsio {
namespace {

const char* const kPassword = "the organ turns slowly";

class AccessRepositoryTest : public DatabaseTest {
 protected:
  static AccessRepository access(Connection& connection) {
    return AccessRepository(connection, PasswordCost::kTest);
  }
  static UserAccount anna() {
    return {.id = "u1", .login = "anna", .createdUtc_us = kSampleTime_us, .roles = {"rater"}};
  }
};

/// The permission matrix by hand (docs/database.md), compared with every cell of the database.
const std::map<std::string, std::set<std::string>> kExpected{
    {"trainee", {"practice", "trial.record_own", "trial.view_own", "mark.view_own", "evaluation.submit"}},
    {"rater", {"practice", "trial.view_assigned", "mark.submit", "evaluation.submit"}},
    {"administrator",
     {"practice",
      "trial.view_coded",
      "mark.release",
      "evaluation.setup",
      "person.view_coded",
      "person.view_identity",
      "person.edit",
      "person.export",
      "person.erase",
      "consent.record",
      "curriculum.edit",
      "study.setup",
      "study.enrol",
      "allocation.view",
      "results.compute",
      "report.export_coded",
      "report.export_named",
      "user.manage",
      "audit.view",
      "database.backup",
      "database.restore",
      "retention.manage",
      "settings.edit"}},
    {"allocator", {"person.view_coded", "allocation.run", "allocation.view", "allocation.reveal"}},
    {"statistician",
     {"trial.view_coded", "mark.view_coded", "person.view_coded", "allocation.view", "results.compute",
      "report.export_coded", "audit.view"}}};

TEST_F(AccessRepositoryTest, EveryCellOfTheMatrixMatches) {
  const std::set<std::pair<std::string, std::string>> permissions = storedPermissions(connection());
  ASSERT_EQ(storedRoles(connection()).size(), kExpected.size());

  std::size_t cells = 0;
  for (const std::string& role : storedRoles(connection())) {
    for (const std::string& operation : storedOperations(connection())) {
      ++cells;
      EXPECT_EQ(permissions.contains({role, operation}), kExpected.at(role).contains(operation))
          << role << " / " << operation;
    }
  }
  EXPECT_EQ(cells, 5U * 32U);
}

TEST_F(AccessRepositoryTest, AnAdministratorCannotTouchMarksAndAnAllocatorCannotEnrol) {
  const auto permissions = storedPermissions(connection());
  EXPECT_FALSE(permissions.contains({"administrator", "mark.submit"}));
  EXPECT_FALSE(permissions.contains({"administrator", "allocation.run"}));
  EXPECT_FALSE(permissions.contains({"allocator", "study.enrol"}));
  EXPECT_FALSE(permissions.contains({"statistician", "person.view_identity"}));
}

TEST_F(AccessRepositoryTest, AllowsOnlyWhatARoleAllows) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);

  EXPECT_TRUE(repository.allowed("u1", "mark.submit"));
  EXPECT_FALSE(repository.allowed("u1", "person.erase"));
  EXPECT_FALSE(repository.allowed("u1", "no such operation"));
  EXPECT_FALSE(repository.allowed("nobody", "practice"));
  repository.setRoles("u1", {"rater", "administrator"});
  EXPECT_TRUE(repository.allowed("u1", "person.erase"));
  repository.setActive("u1", false);
  EXPECT_FALSE(repository.allowed("u1", "mark.submit"));
}

TEST_F(AccessRepositoryTest, HasNoUsersInitially) {
  EXPECT_TRUE(access(connection()).users().empty());
}

TEST_F(AccessRepositoryTest, RequiresANewPasswordAtTheFirstSignIn) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  EXPECT_EQ(repository.signIn("anna", kPassword, kSampleTime_us).outcome, SignIn::kMustChange);

  repository.setPassword("u1", repository.sealPassword("u1", "a sentence of her own"), false);

  EXPECT_EQ(repository.signIn("anna", kPassword, kSampleTime_us).outcome, SignIn::kWrong);
  const SignInResult result = repository.signIn("anna", "a sentence of her own", kSampleTime_us);
  EXPECT_EQ(result.outcome, SignIn::kOk);
  EXPECT_EQ(result.userId, "u1");
}

TEST_F(AccessRepositoryTest, StoresOnlyASaltedHash) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  UserAccount ben = anna();
  ben.id = "u2";
  ben.login = "ben";
  repository.addUser(ben, kPassword);

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM app_user WHERE password_hash LIKE '$argon2id$%'"),
            2);
  EXPECT_EQ(numberFrom(connection(), "SELECT count(DISTINCT password_hash) FROM app_user"), 2);
}

TEST_F(AccessRepositoryTest, DoesNotDistinguishAWrongLoginFromAWrongPassword) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  EXPECT_EQ(repository.signIn("nobody", kPassword, 0).outcome, SignIn::kWrong);
  EXPECT_EQ(repository.signIn("anna", "something else entirely", 0).outcome, SignIn::kWrong);
}

TEST_F(AccessRepositoryTest, SlowsDownGuessingUntilASuccess) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  std::int64_t now_us = kSampleTime_us;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(repository.signIn("anna", "guess", now_us).outcome, SignIn::kWrong);
  }

  const SignInResult wait = repository.signIn("anna", kPassword, now_us);
  EXPECT_EQ(wait.outcome, SignIn::kWait);
  EXPECT_EQ(wait.waitUntilUtc_us, now_us + kSecond_us);
  now_us = wait.waitUntilUtc_us;
  EXPECT_EQ(repository.signIn("anna", "guess", now_us).outcome, SignIn::kWrong);
  EXPECT_EQ(repository.signIn("anna", kPassword, now_us + kSecond_us).outcome, SignIn::kWait);
  EXPECT_EQ(repository.signIn("anna", kPassword, now_us + 2 * kSecond_us).outcome, SignIn::kMustChange);
  EXPECT_EQ(repository.signIn("anna", "guess", now_us + 2 * kSecond_us).outcome, SignIn::kWrong);
  EXPECT_EQ(repository.signIn("anna", kPassword, now_us + 2 * kSecond_us).outcome, SignIn::kMustChange);
}

TEST_F(AccessRepositoryTest, FailuresMakeOnlyTheirPlaceWait) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  for (int i = 0; i < 20; ++i) {
    for (const char* login : {"anna", "nobody"}) {
      const SignIn answered = repository.signIn(login, "guess", kSampleTime_us, "192.0.2.1").outcome;
      EXPECT_EQ(answered, i <= kFreeFailures ? SignIn::kWrong : SignIn::kWait) << login << i;
    }
  }

  EXPECT_EQ(repository.signIn("anna", kPassword, kSampleTime_us, "192.0.2.1").outcome, SignIn::kWait);
  EXPECT_EQ(repository.signIn("anna", kPassword, kSampleTime_us, "192.0.2.2").outcome, SignIn::kMustChange);
  EXPECT_EQ(repository.signIn("anna", kPassword, kSampleTime_us).outcome, SignIn::kMustChange);
}

TEST_F(AccessRepositoryTest, TreatsUnknownLoginsLikeKnownOnes) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  std::int64_t now_us = kSampleTime_us;

  for (int i = 0; i < 40; ++i) {
    const SignInResult known = repository.signIn("anna", "guess", now_us);
    const SignInResult unknown = repository.signIn("nobody", "guess", now_us);
    EXPECT_EQ(known.outcome, unknown.outcome) << i;
    EXPECT_EQ(known.waitUntilUtc_us, unknown.waitUntilUtc_us) << i;
    const SignInResult pin = repository.signInForPractice("nobody at all", "4711", now_us);
    EXPECT_EQ(pin.outcome, known.outcome) << i;
    now_us += 7 * kSecond_us;
  }

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM sign_in_failure"), 3);
}

TEST_F(AccessRepositoryTest, AFailureInTheFutureLocksForAtMostAMinute) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  const std::int64_t ahead_us = kSampleTime_us + 400 * std::int64_t{86'400'000'000};
  for (int i = 0; i < 8; ++i) {
    (void)repository.signIn("anna", "guess", ahead_us + i * kLongestWait_us);
  }

  const SignInResult wait = repository.signIn("anna", kPassword, kSampleTime_us);

  EXPECT_EQ(wait.outcome, SignIn::kWait);
  EXPECT_LE(wait.waitUntilUtc_us, kSampleTime_us + kLongestWait_us);
  EXPECT_EQ(repository.signIn("anna", kPassword, wait.waitUntilUtc_us).outcome, SignIn::kMustChange);
}

TEST_F(AccessRepositoryTest, NeverWaitsLongerThanAMinute) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  (void)repository.signIn("anna", "guess", 0);
  connection().execute("UPDATE sign_in_failure SET failed_count = ?", {1000});

  EXPECT_EQ(repository.signIn("anna", "guess", 0).outcome, SignIn::kWrong);

  EXPECT_EQ(repository.signIn("anna", kPassword, 0).waitUntilUtc_us, kLongestWait_us);
}

TEST_F(AccessRepositoryTest, ADisabledUserStaysOut) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  repository.setActive("u1", false);
  EXPECT_EQ(repository.signIn("anna", kPassword, 0).outcome, SignIn::kDisabled);
}

TEST_F(AccessRepositoryTest, APinOpensOnlyPractice) {
  AccessRepository repository = access(connection());
  repository.addUser(anna(), kPassword);
  EXPECT_EQ(repository.signInForPractice("anna", "4711", 0).outcome, SignIn::kWrong);
  EXPECT_EQ(refusalFrom([&] { (void)repository.sealPin("123"); }).code, ErrorCode::kBadParameter);
  repository.setPin("u1", repository.sealPin("4711"));

  EXPECT_EQ(repository.signInForPractice("anna", "4711", 0).outcome, SignIn::kOk);
  EXPECT_EQ(repository.signIn("anna", "4711", 0).outcome, SignIn::kWrong);
  EXPECT_EQ(repository.signInForPractice("anna", kPassword, 0).outcome, SignIn::kWrong);
  EXPECT_TRUE(repository.users().at(0).hasPin);
}

TEST(Password, CountsLengthNotComposition) {
  checkPassword("all lower case letters", "anna");
  checkPassword("手手足足手足手足手足手足手足手", "anna");  // fifteen characters, 45 bytes
  for (const char* weak : {"Sh0rt!", "fourteen chars", "aaaaaaaaaaaaaaaaaaaa", "abcabcabcabcabcabc",
                           "1234567890123456", "qwertyuiopasdfgh", "annabauer-anna12"}) {
    EXPECT_EQ(refusalFrom([&] { checkPassword(weak, "annabauer-anna"); }).code, ErrorCode::kBadParameter)
        << weak;
  }
}

TEST(Password, RejectsCommonPasswords) {
  for (const char* common : {"passwordpassword", "Password12345678!", "P@ssw0rdP@ssw0rd",
                             "Welcome to Torsio 2026", "letmein-letmein-1", "iloveyou!iloveyou?",
                             "qwerty123456qwerty", "1qaz2wsx3edc4rfv", "Summer2026Summer2026",
                             "Correct horse battery staple", "the quick brown fox", "hospital-admin-2026"}) {
    EXPECT_EQ(refusalFrom([&] { checkPassword(common, "anna"); }).code, ErrorCode::kBadParameter) << common;
  }
  for (const char* own : {"seven kites above the bay", "my sunny winter garden",
                          "a password of my own making", "KJWQX-PZMRT-VBHLD-SGFNC", "314159265358979323"}) {
    checkPassword(own, "anna");
  }
}

TEST_F(AccessRepositoryTest, APasswordMatchesOnlyItself) {
  const std::string hash = hashPassword(kPassword, PasswordCost::kTest);
  EXPECT_TRUE(passwordMatches(connection(), hash, kPassword));
  EXPECT_FALSE(passwordMatches(connection(), hash, "the organ turns slowlY"));
  EXPECT_FALSE(passwordMatches(connection(), "not a hash", kPassword));
  EXPECT_EQ(hashLike(hash, kPassword), hash);
  EXPECT_EQ(hashLike("not a hash", kPassword), "");
}

}  // namespace
}  // namespace torsio
