// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/access_repository.h"

#include <algorithm>

#include "sim/base/error.h"

namespace torsio {

namespace {

std::vector<std::string> textsFrom(Connection& connection, const char* sql) {
  std::vector<std::string> texts;
  Statement row = connection.prepare(sql);
  row.execute();
  while (row.step()) texts.push_back(row.text(0));
  return texts;
}

void insertRoles(Connection& connection, const std::string& userId, const std::vector<std::string>& roles) {
  Statement insert = connection.prepare("INSERT INTO user_role (user_id, role_code) VALUES (?, ?)");
  for (const std::string& role : roles) insert.execute({userId, role});
}

}  // namespace

struct AccessRepository::Account {
  std::string id;
  std::string passwordHash;
  std::string pinHash;
  bool mustChange = false;
  bool active = false;
  std::int64_t failures = 0;
  std::int64_t lockedUntilUtc_us = 0;
};

std::set<std::pair<std::string, std::string>> AccessRepository::permissions() {
  std::set<std::pair<std::string, std::string>> pairs;
  Statement row = connection_.prepare("SELECT role_code, operation_code FROM role_operation");
  row.execute();
  while (row.step()) pairs.emplace(row.text(0), row.text(1));
  return pairs;
}

std::vector<std::string> AccessRepository::roles() {
  return textsFrom(connection_, "SELECT code FROM role ORDER BY code");
}

std::vector<std::string> AccessRepository::operations() {
  return textsFrom(connection_, "SELECT code FROM operation ORDER BY code");
}

bool AccessRepository::allowed(const std::string& userId, const std::string& operation) {
  Statement row = connection_.prepare(
      "SELECT count(*) FROM app_user u JOIN user_role r ON r.user_id = u.id"
      " JOIN role_operation o ON o.role_code = r.role_code"
      " WHERE u.id = ? AND u.state = 'active' AND o.operation_code = ?");
  row.execute({userId, operation});
  return row.step() && row.int64(0) > 0;
}

SealedSecret AccessRepository::sealPassword(const std::string& login, const std::string& password) const {
  checkPassword(password, login);
  return {hashPassword(password, cost_)};
}

SealedSecret AccessRepository::sealPin(const std::string& pin) const {
  if (pin.empty()) return {};
  if (pin.size() < static_cast<std::size_t>(kShortestPin)) {
    throw Error(ErrorCode::kBadParameter, Text("the PIN is shorter than %1 digits", kShortestPin), "PIN",
                "Take a longer one");
  }
  return {hashPassword(pin, cost_)};
}

void AccessRepository::addUser(const StoredUser& user, const SealedSecret& password) {
  Transaction transaction(connection_);
  connection_.execute(
      "INSERT INTO app_user (id, login, person_id, password_hash, must_change_password, state, failed_count,"
      " locked_until_utc_us, created_utc_us, demonstration) VALUES (?, ?, ?, ?, ?, ?, 0, 0, ?, ?)",
      {user.id, user.login, textOrNull(user.personId), password.hash, true,
       user.active ? "active" : "disabled", user.createdUtc_us, user.demonstration});
  insertRoles(connection_, user.id, user.roles);
  transaction.commit();
}

std::vector<StoredUser> AccessRepository::users() {
  std::vector<StoredUser> users;
  Statement row = connection_.prepare(
      "SELECT u.id, u.login, u.person_id, u.must_change_password, u.state, u.pin_hash, u.created_utc_us,"
      " u.demonstration, r.role_code FROM app_user u LEFT JOIN user_role r ON r.user_id = u.id"
      " ORDER BY u.login, r.role_code");
  row.execute();
  while (row.step()) {
    if (users.empty() || users.back().id != row.text(0)) {
      users.push_back({.id = row.text(0),
                       .login = row.text(1),
                       .personId = row.text(2),
                       .mustChangePassword = row.boolean(3),
                       .active = row.text(4) == "active",
                       .hasPin = !row.isNull(5),
                       .createdUtc_us = row.int64(6),
                       .demonstration = row.boolean(7)});
    }
    if (!row.isNull(8)) users.back().roles.push_back(row.text(8));
  }
  return users;
}

void AccessRepository::setRoles(const std::string& userId, const std::vector<std::string>& roles) {
  Transaction transaction(connection_);
  connection_.execute("DELETE FROM user_role WHERE user_id = ?", {userId});
  insertRoles(connection_, userId, roles);
  transaction.commit();
}

void AccessRepository::setActive(const std::string& userId, bool active) {
  connection_.execute("UPDATE app_user SET state = ? WHERE id = ?", {active ? "active" : "disabled", userId});
}

std::optional<AccessRepository::Account> AccessRepository::account(const std::string& login) {
  Statement row = connection_.prepare(
      "SELECT id, password_hash, pin_hash, must_change_password, state, failed_count, locked_until_utc_us"
      " FROM app_user WHERE login = ?");
  row.execute({login});
  if (!row.step()) return std::nullopt;
  return Account{row.text(0),  row.text(1), row.text(2), row.boolean(3), row.text(4) == "active",
                 row.int64(5), row.int64(6)};
}

void AccessRepository::noteFailure(const std::string& userId, std::int64_t failures, std::int64_t now_us) {
  constexpr std::int64_t kFirstWait_us = 1'000'000;
  constexpr std::int64_t kDoublings = 10;  // 2^10 s is beyond the longest wait
  std::int64_t wait_us = 0;
  if (failures > kFreeFailures) {
    wait_us = std::min(kFirstWait_us << std::min(failures - kFreeFailures - 1, kDoublings), kLongestWait_us);
  }
  connection_.execute("UPDATE app_user SET failed_count = ?, locked_until_utc_us = ? WHERE id = ?",
                      {failures, now_us + wait_us, userId});
}

SignInResult AccessRepository::check(const std::string& login, const std::string& secret, bool pin,
                                     std::int64_t now_us) {
  const std::optional<Account> found = account(login);
  const std::string hash = !found ? std::string() : pin ? found->pinHash : found->passwordHash;
  if (hash.empty()) {
    // The same work as for a known login, so that the time does not tell which logins exist.
    (void)hashPassword(secret, cost_);
    return {SignIn::kWrong};
  }
  if (now_us < found->lockedUntilUtc_us) return {SignIn::kWait, "", found->lockedUntilUtc_us};
  if (!passwordMatches(hash, secret)) {
    noteFailure(found->id, found->failures + 1, now_us);
    return {SignIn::kWrong};
  }
  if (!found->active) return {SignIn::kDisabled};
  if (found->failures > 0) noteFailure(found->id, 0, 0);
  return {found->mustChange && !pin ? SignIn::kMustChange : SignIn::kOk, found->id};
}

SignInResult AccessRepository::signIn(const std::string& login, const std::string& password,
                                      std::int64_t now_us) {
  return check(login, password, false, now_us);
}

SignInResult AccessRepository::signInForPractice(const std::string& login, const std::string& pin,
                                                 std::int64_t now_us) {
  return check(login, pin, true, now_us);
}

void AccessRepository::setPassword(const std::string& userId, const SealedSecret& password, bool mustChange) {
  connection_.execute(
      "UPDATE app_user SET password_hash = ?, must_change_password = ?, failed_count = 0,"
      " locked_until_utc_us = 0 WHERE id = ?",
      {password.hash, mustChange, userId});
}

void AccessRepository::setPin(const std::string& userId, const SealedSecret& pin) {
  connection_.execute("UPDATE app_user SET pin_hash = ? WHERE id = ?", {textOrNull(pin.hash), userId});
}

}  // namespace torsio
