// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/access_repository.h"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <tuple>
#include <utility>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/password_rule.h"
#include "db/connection/row_reader.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/people/second_factor_repository.h"
#include "db/repository/people/server_roles.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

void insertRoles(Connection& connection, const UserId& userId, const std::vector<std::string>& roles) {
  Statement insert = connection.prepare(insertInto("user_role", "user_id, role_code"));
  for (const std::string& role : roles) {
    insert.execute({userId, role});
  }
}

/// Returns the wait after a number of consecutive failures.
std::int64_t waitAfter(std::int64_t failures) {
  constexpr std::int64_t kFirstWait_us = 1'000'000;
  constexpr std::int64_t kDoublings = 6;  // 2^6 s exceeds the longest wait
  if (failures <= kFreeFailures) {
    return 0;
  }
  return std::min(kFirstWait_us << std::min(failures - kFreeFailures - 1, kDoublings), kLongestWait_us);
}

}  // namespace

struct AccessRepository::Account {
  UserId id;  ///< empty: no such login
  std::int64_t bucket = 0;
  std::string passwordHash;
  std::string pinHash;
  bool mustChange = false;
  bool active = false;
  std::int64_t failures = 0;
  std::int64_t lockedUntilUtc_us = 0;
};

bool AccessRepository::allowed(const UserId& userId, const std::string& operation) const {
  return selectFirst(connection_,
                     "SELECT count(*) FROM app_user u JOIN user_role r ON r.user_id = u.id"
                     " JOIN role_operation o ON o.role_code = r.role_code"
                     " WHERE u.id = ? AND u.state = 'active' AND o.operation_code = ?",
                     {userId, operation}, readInt64)
             .value_or(0) > 0;
}

bool AccessRepository::isOfDemonstration(const UserId& userId) const {
  return selectFirst(connection_, "SELECT demonstration FROM app_user WHERE id = ?", {userId}, readBoolean)
      .value_or(false);
}

std::vector<std::string> AccessRepository::logins() const {
  return selectAll(connection_, "SELECT login FROM app_user ORDER BY login", {}, readText);
}

std::string AccessRepository::loginOf(const PersonId& personId) const {
  return selectFirst(connection_, "SELECT login FROM app_user WHERE person_id = ? ORDER BY login", {personId},
                     readText)
      .value_or("");
}

SealedSecret AccessRepository::sealPassword(const std::string& login, const std::string& password) const {
  checkPassword(password, login);
  return {hiddenPassword(connection_, hashPassword(password, cost_))};
}

SealedSecret AccessRepository::sealPin(const std::string& pin) const {
  if (pin.empty()) {
    return {};
  }
  if (pin.size() < static_cast<std::size_t>(kShortestPin)) {
    refuseParameter(Text::tr("the PIN is shorter than %1 digits", kShortestPin), Text::tr("PIN"),
                    Text::tr("Use a longer one"));
  }
  return {hiddenPassword(connection_, hashPassword(pin, cost_))};
}

void AccessRepository::addUser(const UserAccount& user, const SealedSecret& password) {
  Transaction transaction(connection_);
  connection_.execute(
      "INSERT INTO app_user (id, login, person_id, password_hash, must_change_password, state, failed_count,"
      " locked_until_utc_us, created_utc_us, demonstration) VALUES (?, ?, ?, ?, ?, ?, 0, 0, ?, ?)",
      {user.id, user.login, textOrNull(user.personId), password.hash, true,
       user.active ? "active" : "disabled", user.createdUtc_us, user.demonstration});
  insertRoles(connection_, user.id, user.roles);
  transaction.commit();
}

std::vector<UserAccount> AccessRepository::users() const {
  Statement statement = connection_.prepare(
      "SELECT u.id, u.login, u.person_id, u.must_change_password, u.state, u.pin_hash, u.created_utc_us,"
      " u.demonstration, r.role_code FROM app_user u LEFT JOIN user_role r ON r.user_id = u.id"
      " ORDER BY u.login, r.role_code");
  statement.execute();
  std::vector<UserAccount> users;
  while (statement.step()) {  // one row per role
    RowReader row(statement);
    UserAccount user{.id = row.text(),
                     .login = row.text(),
                     .personId = row.text(),
                     .mustChangePassword = row.boolean(),
                     .active = row.text() == "active",
                     .hasPin = row.hasValue(),
                     .createdUtc_us = row.int64(),
                     .demonstration = row.boolean()};
    const std::optional<std::string> role = row.maybeText();
    if (users.empty() || users.back().id != user.id) {
      users.push_back(std::move(user));
    }
    if (role) {
      users.back().roles.push_back(*role);
    }
  }
  return users;
}

void AccessRepository::setRoles(const UserId& userId, const std::vector<std::string>& roles) {
  Transaction transaction(connection_);
  std::vector<std::string> added = roles;
  for (const std::string& held :
       selectAll(connection_, "SELECT role_code FROM user_role WHERE user_id = ?", {userId}, readText)) {
    if (std::erase(added, held) == 0) {
      connection_.execute("DELETE FROM user_role WHERE user_id = ? AND role_code = ?", {userId, held});
    }
  }
  insertRoles(connection_, userId, added);
  (void)revokeInvitation(userId);
  transaction.commit();
}

void AccessRepository::setActive(const UserId& userId, bool active) {
  (void)revokeInvitation(userId);
  connection_.execute("UPDATE app_user SET state = ? WHERE id = ?", {active ? "active" : "disabled", userId});
}

std::optional<AccessRepository::Account> AccessRepository::account(const std::string& login) const {
  return selectFirst(connection_,
                     "SELECT id, password_hash, pin_hash, must_change_password, state FROM app_user"
                     " WHERE login = ?",
                     {login}, [](RowReader& row) {
                       return Account{
                           row.text(), 0, row.text(), row.text(), row.boolean(), row.text() == "active"};
                     });
}

void AccessRepository::readFailures(Account& account, const std::string& login,
                                    const std::string& place) const {
  const std::string secret =
      account.id.empty() ? selectFirst(connection_, "SELECT id FROM centre", {}, readText).value_or("")
                         : account.passwordHash;
  Digest digest;
  for (const std::string& part : {secret, place, login}) {
    digest.update(static_cast<std::int64_t>(part.size()));
    digest.update(std::string_view(part));
  }
  const Digest::Value hash = digest.value();
  account.bucket = (static_cast<std::int64_t>(hash[0]) << 8) | hash[1];
  if (const auto known = selectFirst(connection_,
                                     "SELECT failed_count, locked_until_utc_us FROM sign_in_failure"
                                     " WHERE bucket = ?",
                                     {account.bucket}, [](RowReader& row) {
                                       return std::pair<std::int64_t, std::int64_t>{row.int64(), row.int64()};
                                     })) {
    std::tie(account.failures, account.lockedUntilUtc_us) = *known;
  }
}

void AccessRepository::setFailures(const Account& account, std::int64_t failures,
                                   std::int64_t lockedUntilUtc_us) {
  connection_.execute(insertInto("sign_in_failure", "bucket, failed_count, locked_until_utc_us") +
                          " ON CONFLICT (bucket) DO UPDATE SET failed_count = excluded.failed_count,"
                          " locked_until_utc_us = excluded.locked_until_utc_us",
                      {account.bucket, failures, lockedUntilUtc_us});
}

std::optional<std::int64_t> AccessRepository::waitOf(const Account& account, std::int64_t now_us) {
  if (account.lockedUntilUtc_us > now_us + kLongestWait_us) {
    // The clock was set back since. Restart the wait, which never exceeds the maximum.
    setFailures(account, account.failures, now_us + kLongestWait_us);
    return now_us + kLongestWait_us;
  }
  return now_us < account.lockedUntilUtc_us ? std::optional(account.lockedUntilUtc_us) : std::nullopt;
}

bool AccessRepository::fits(const Account& account, const std::string& login, const std::string& secret,
                            bool pin, SignInResult& result) {
  const std::string& stored = pin ? account.pinHash : account.passwordHash;
  if (stored.empty()) {
    // Does the same work as for a known login, so that timing does not reveal which logins exist.
    (void)hashPassword(secret, cost_);
    if (isPrepared(connection_)) {
      (void)selectFirst(connection_, "SELECT open_session(?, '', ?)", {login, pin},
                        [](RowReader& row) { return row.maybeText(); });
    }
    return false;
  }
  if (!isHiddenPassword(stored) || !isPrepared(connection_)) {
    return passwordMatches(connection_, stored, secret);
  }
  const std::optional<std::optional<std::string>> token =
      selectFirst(connection_, "SELECT open_session(?, ?, ?)", {login, hashLike(stored, secret), pin},
                  [](RowReader& row) { return row.maybeText(); });
  result.serverToken = token.value_or(std::nullopt).value_or("");
  return token && token->has_value();
}

std::string AccessRepository::openInvitedSession(const std::string& proof) {
  return isPrepared(connection_)
             ? selectFirst(connection_, "SELECT open_invited_session(?)", {proof}, readText).value_or("")
             : std::string();
}

std::string AccessRepository::openSimulatedSession(const UserId& userId) {
  return isPrepared(connection_)
             ? selectFirst(connection_, "SELECT open_simulated_session(?)", {userId}, readText).value_or("")
             : std::string();
}

void AccessRepository::endOwnServerSession() {
  if (isPrepared(connection_)) {
    // Selects a row without columns: the function returns nothing.
    (void)selectFirst(connection_, "SELECT count(*) FROM (SELECT end_own_session()) AS done", {}, readInt64);
  }
}

void AccessRepository::endOtherServerSessions(const UserId& userId) {
  if (isPrepared(connection_)) {
    (void)selectFirst(connection_, "SELECT count(*) FROM (SELECT end_other_sessions(?)) AS done",
                      {userId.text()}, readInt64);
  }
}

struct AccessRepository::Typed {
  const std::string& login;
  const std::string& secret;
  const std::string& place;
  bool pin = false;
  const std::string* code = nullptr;  ///< of the second factor; null: not asked for
};

SignInResult AccessRepository::check(const Typed& typed, std::int64_t now_us) {
  Account found = account(typed.login).value_or(Account{});
  readFailures(found, typed.login, typed.place);
  if (const std::optional<std::int64_t> until_us = waitOf(found, now_us)) {
    return {SignIn::kWait, "", *until_us};
  }
  SignInResult result;
  if (!fits(found, typed.login, typed.secret, typed.pin, result)) {
    setFailures(found, found.failures + 1, now_us + waitAfter(found.failures + 1));
    return {SignIn::kWrong};
  }
  if (!found.active) {
    return {SignIn::kDisabled};
  }
  if (typed.code != nullptr) {
    if (const SignIn outcome = checkCode(found, typed, now_us, result); outcome != SignIn::kOk) {
      endOwnServerSession();  // opened by the password
      return {outcome, "", result.waitUntilUtc_us};
    }
  }
  if (found.failures > 0) {
    setFailures(found, 0, 0);
  }
  result.outcome = found.mustChange && !typed.pin ? SignIn::kMustChange : SignIn::kOk;
  result.userId = found.id;
  return result;
}

SignIn AccessRepository::checkCode(const Account& account, const Typed& typed, std::int64_t now_us,
                                   SignInResult& result) {
  tellSession(connection_, result.serverToken);
  if (!SecondFactorRepository(connection_).find(account.id)) {
    return SignIn::kOk;
  }
  result.hasSecondFactor = true;
  Account codes = account;
  codes.failures = 0;
  codes.lockedUntilUtc_us = 0;
  readFailures(codes, typed.login, "codes of the second factor");  // whoever gets here knows the password
  if (const std::optional<std::int64_t> until_us = waitOf(codes, now_us)) {
    result.waitUntilUtc_us = *until_us;
    return SignIn::kWait;
  }
  if (typed.code->empty()) {
    return SignIn::kCodeNeeded;
  }
  if (!acceptsCode(account, typed, now_us, result)) {
    setFailures(codes, codes.failures + 1, now_us + waitAfter(codes.failures + 1));
    return SignIn::kCodeWrong;
  }
  if (codes.failures > 0) {
    setFailures(codes, 0, 0);
  }
  return SignIn::kOk;
}

bool AccessRepository::acceptsCode(const Account& account, const Typed& typed, std::int64_t now_us,
                                   SignInResult& result) {
  SecondFactorRepository factors(connection_);
  std::string code = *typed.code;
  std::erase_if(code, [](char c) { return c == ' ' || c == '-'; });
  if (code.find_first_not_of("0123456789") != std::string::npos) {
    result.byRecoveryCode = factors.useRecoveryCode(account.id, code);
    return result.byRecoveryCode;
  }
  const std::string secret =
      openedCodeSecret(factors.find(account.id).value_or(SecondFactor{}).sealed, typed.secret, account.id);
  const std::optional<std::int64_t> step = secret.empty() ? std::nullopt : stepOfCode(secret, code, now_us);
  return step && factors.useStep(account.id, *step);
}

SignInResult AccessRepository::signIn(const std::string& login, const std::string& password,
                                      std::int64_t now_us, const std::string& place,
                                      const std::string& code) {
  return check({.login = login, .secret = password, .place = place, .code = &code}, now_us);
}

SignInResult AccessRepository::signInAgain(const std::string& login, const std::string& password,
                                           std::int64_t now_us, const std::string& place) {
  return check({.login = login, .secret = password, .place = place}, now_us);
}

SignInResult AccessRepository::signInForPractice(const std::string& login, const std::string& pin,
                                                 std::int64_t now_us, const std::string& place) {
  return check({.login = login, .secret = pin, .place = place, .pin = true}, now_us);
}

void AccessRepository::storePassword(const UserId& userId, const SealedSecret& password, bool mustChange) {
  (void)revokeInvitation(userId);
  connection_.execute(
      "UPDATE app_user SET password_hash = ?, must_change_password = ?, failed_count = 0,"
      " locked_until_utc_us = 0 WHERE id = ?",
      {password.hash, mustChange, userId});
  endOtherServerSessions(userId);
}

bool AccessRepository::setPassword(const UserId& userId, const SealedSecret& password, bool mustChange) {
  Transaction transaction(connection_);
  const bool had = SecondFactorRepository(connection_).remove(userId);
  storePassword(userId, password, mustChange);
  transaction.commit();
  return had;
}

void AccessRepository::changePassword(const UserId& userId, const SealedSecret& password,
                                      const std::string& sealedCode) {
  Transaction transaction(connection_);
  storePassword(userId, password, false);
  if (!sealedCode.empty()) {
    SecondFactorRepository(connection_).reseal(userId, sealedCode);
  }
  transaction.commit();
}

void AccessRepository::setPin(const UserId& userId, const SealedSecret& pin) {
  connection_.execute("UPDATE app_user SET pin_hash = ? WHERE id = ?", {textOrNull(pin.hash), userId});
}

void AccessRepository::setKioskCode(const std::string& id, const UserId& userId, const std::string& proof,
                                    std::int64_t utc_us) {
  Transaction transaction(connection_);
  (void)revokeKioskCode(userId, utc_us);
  connection_.execute(insertInto("kiosk_code", "id, user_id, code_hash, made_utc_us"),
                      {id, userId, keptOfProof(proof), utc_us});
  transaction.commit();
}

bool AccessRepository::revokeKioskCode(const UserId& userId, std::int64_t utc_us) {
  return connection_.execute(
             "UPDATE kiosk_code SET revoked_utc_us = ? WHERE user_id = ? AND revoked_utc_us IS NULL",
             {utc_us, userId}) > 0;
}

std::vector<KioskCodeRow> AccessRepository::kioskCodes() const {
  return selectAll(
      connection_,
      "SELECT user_id, made_utc_us FROM kiosk_code WHERE revoked_utc_us IS NULL ORDER BY made_utc_us, id", {},
      [](RowReader& row) {
        return KioskCodeRow{row.text(), row.int64()};
      });
}

void AccessRepository::addInvitation(const std::string& id, const InvitationRow& invitation,
                                     const std::string& proof) {
  Transaction transaction(connection_);
  (void)revokeInvitation(invitation.userId);
  connection_.execute(
      insertInto("invitation", "id, user_id, token_hash, made_utc_us, expires_utc_us, state"),
      {id, invitation.userId, keptOfProof(proof), invitation.madeUtc_us, invitation.expiresUtc_us, "open"});
  transaction.commit();
}

bool AccessRepository::revokeInvitation(const UserId& userId) {
  return connection_.execute("UPDATE invitation SET state = 'revoked' WHERE user_id = ? AND state = 'open'",
                             {userId}) > 0;
}

std::vector<InvitationRow> AccessRepository::openInvitations() const {
  return selectAll(connection_,
                   "SELECT user_id, made_utc_us, expires_utc_us FROM invitation WHERE state = 'open'"
                   " ORDER BY made_utc_us, id",
                   {}, [](RowReader& row) {
                     return InvitationRow{row.text(), row.int64(), row.int64()};
                   });
}

OutdatedAccess AccessRepository::outdatedAccess(std::int64_t now_us) const {
  const auto readUser = [](RowReader& row) { return UserId(row.text()); };
  const std::string current = std::string(kKeptProof) + "%";
  OutdatedAccess outdated;
  if (isPrepared(connection_)) {
    outdated.cards = selectAll(connection_,
                               "SELECT user_id FROM kiosk_code WHERE revoked_utc_us IS NULL"
                               " AND code_hash NOT LIKE ? ORDER BY user_id",
                               {current}, readUser);
  }
  outdated.links = selectAll(connection_,
                             "SELECT user_id FROM invitation WHERE state = 'open' AND expires_utc_us > ?"
                             " AND token_hash NOT LIKE ? ORDER BY user_id",
                             {now_us, current}, readUser);
  return outdated;
}

std::optional<UserId> AccessRepository::invited(const std::string& proof, std::int64_t now_us) const {
  return selectFirst(connection_,
                     "SELECT u.id FROM invitation i JOIN app_user u ON u.id = i.user_id WHERE"
                     " i.token_hash = ? AND i.state = 'open' AND i.expires_utc_us > ?"
                     " AND u.state = 'active'",
                     {keptOfProof(proof), now_us}, [](RowReader& row) { return UserId(row.text()); });
}

bool AccessRepository::useInvitation(const std::string& proof, std::int64_t now_us) {
  return connection_.execute(
             "UPDATE invitation SET state = 'used' WHERE token_hash = ? AND state = 'open'"
             " AND expires_utc_us > ?",
             {keptOfProof(proof), now_us}) == 1;
}

void AccessRepository::endSessions(const UserId& userId) {
  Transaction transaction(connection_);
  const auto ended = selectFirst(connection_, "SELECT COALESCE(sessions_ended, 0) FROM app_user WHERE id = ?",
                                 {userId}, [](RowReader& row) { return row.int64(); });
  connection_.execute("UPDATE app_user SET sessions_ended = ? WHERE id = ?", {ended.value_or(0) + 1, userId});
  endOtherServerSessions(userId);
  transaction.commit();
}

std::string AccessRepository::passwordStamp(const UserId& userId) const {
  const auto stamp = selectFirst(
      connection_,
      "SELECT password_hash, COALESCE(sessions_ended, 0) FROM app_user WHERE id = ? AND state = 'active'",
      {userId}, [](RowReader& row) {
        std::string hash = row.text();
        return hash.append(" ").append(std::to_string(row.int64()));
      });
  if (!stamp) {
    return {};
  }
  Digest digest;
  digest.update(std::string_view(*stamp));
  return digest.hex();
}

namespace {

struct CardHolder {
  UserId id;
  bool active = false;
  std::string serverToken{};
};

/// Returns the trainee whose card this proves; empty: nobody. A file may hold cards of which it keeps the
/// proof.
std::optional<CardHolder> holderOf(Connection& connection, const std::string& proof) {
  if (!isPrepared(connection)) {
    return selectFirst(connection,
                       "SELECT u.id, u.state FROM kiosk_code k JOIN app_user u ON u.id = k.user_id"
                       " WHERE k.code_hash IN (?, ?) AND k.revoked_utc_us IS NULL AND NOT EXISTS"
                       " (SELECT 1 FROM user_role r WHERE r.user_id = u.id AND r.role_code <> 'trainee')",
                       {keptOfProof(proof), proof}, [](RowReader& row) {
                         return CardHolder{row.text(), row.text() == "active"};
                       });
  }
  std::istringstream answer(
      selectFirst(connection, "SELECT open_session_with_code(?)", {proof}, readText).value_or(""));
  std::string id;
  std::string state;
  std::string token;
  answer >> id >> state >> token;
  return id.empty() ? std::nullopt : std::optional(CardHolder{id, state == "active", token});
}

}  // namespace

SignInResult AccessRepository::signInWithCode(const std::string& proof, const std::string& station,
                                              std::int64_t now_us) {
  Account gate;
  readFailures(gate, "card", station);
  if (const std::optional<std::int64_t> until_us = waitOf(gate, now_us)) {
    return {SignIn::kWait, "", *until_us};
  }
  const std::optional<CardHolder> found = holderOf(connection_, proof);
  if (!found) {
    setFailures(gate, gate.failures + 1, now_us + waitAfter(gate.failures + 1));
    return {SignIn::kWrong};
  }
  if (!found->active) {
    return {SignIn::kDisabled};
  }
  if (gate.failures > 0) {
    setFailures(gate, 0, 0);
  }
  return {.outcome = SignIn::kOk, .userId = found->id, .serverToken = found->serverToken};
}

}  // namespace torsio
