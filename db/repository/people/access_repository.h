// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/connection/connection.h"
#include "db/repository/people/password.h"

namespace torsio {

/// Somebody who may sign in. No default user and no default password exist.
struct StoredUser {
  std::string id{};
  std::string login{};     ///< unique
  std::string personId{};  ///< empty: nobody of the record (an administrator, say)
  bool mustChangePassword = true;
  bool active = true;
  bool hasPin = false;  ///< filled when read
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
  std::vector<std::string> roles{};  ///< codes
};

enum class SignIn {
  kOk,
  kMustChange,  ///< right, but nothing else is allowed before a new password is set
  kWrong,       ///< unknown login or wrong password: which of the two is not told
  kWait,        ///< too many failures: not even tried
  kDisabled,    ///< right, but the user was disabled
};

struct SignInResult {
  SignIn outcome = SignIn::kWrong;
  std::string userId{};              ///< for kOk and kMustChange
  std::int64_t waitUntilUtc_us = 0;  ///< for kWait
};

/// Failures in a row that cost nothing; each one more doubles the wait, from one second to fifteen minutes.
inline constexpr std::int64_t kFreeFailures = 3;
inline constexpr std::int64_t kLongestWait_us = 900'000'000;

/// A password or PIN as it is stored; empty: none.
struct SealedSecret {
  std::string hash{};
};

/// Users, roles, and the matrix role x operation (data of the migration). Default deny.
class AccessRepository {
 public:
  explicit AccessRepository(Connection& connection, PasswordCost cost = PasswordCost::kModerate)
      : connection_(connection), cost_(cost) {}

  /// Whether one of the user's roles has the operation; unknown and disabled users may nothing.
  [[nodiscard]] bool allowed(const std::string& userId, const std::string& operation) const;

  /// Sealing takes about a second on purpose: do it before a transaction begins, or everybody else waits for
  /// the database meanwhile. Throw Error (kBadParameter) for a weak secret; an empty PIN is none.
  [[nodiscard]] SealedSecret sealPassword(const std::string& login, const std::string& password) const;
  [[nodiscard]] SealedSecret sealPin(const std::string& pin) const;

  /// The password must be changed at the first sign-in.
  void addUser(const StoredUser& user, const SealedSecret& password);
  void addUser(const StoredUser& user, const std::string& password) {
    addUser(user, sealPassword(user.login, password));
  }
  [[nodiscard]] std::vector<StoredUser> users() const;
  void setRoles(const std::string& userId, const std::vector<std::string>& roles);
  void setActive(const std::string& userId, bool active);

  [[nodiscard]] SignInResult signIn(const std::string& login, const std::string& password,
                                    std::int64_t now_us);
  /// Own change, or a reset by an administrator (`mustChange`). Ends any wait.
  void setPassword(const std::string& userId, const SealedSecret& password, bool mustChange);

  /// A station PIN opens practice without a record and nothing else; none removes it.
  void setPin(const std::string& userId, const SealedSecret& pin);
  [[nodiscard]] SignInResult signInForPractice(const std::string& login, const std::string& pin,
                                               std::int64_t now_us);

 private:
  struct Account;
  [[nodiscard]] std::optional<Account> account(const std::string& login) const;
  [[nodiscard]] SignInResult check(const std::string& login, const std::string& secret, bool pin,
                                   std::int64_t now_us);
  void noteFailure(const std::string& userId, std::int64_t failures, std::int64_t now_us);

  Connection& connection_;
  PasswordCost cost_;
};

}  // namespace torsio
