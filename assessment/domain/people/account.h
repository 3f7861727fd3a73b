// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"

namespace torsio {

/// Cost of one password hash (Argon2id of libsodium) in memory and time.
enum class PasswordCost {
  kTest,  ///< the minimum that the library allows; tests only
  kFull,  ///< 64 MiB, three passes: the second recommended choice of RFC 9106; about 0.15 s
};

/// An account that may sign in. There is no default user and no default password.
struct UserAccount {
  UserId id{};
  std::string login{};  ///< unique
  PersonId personId{};  ///< empty: not a person of the record, such as an administrator
  bool mustChangePassword = true;
  bool active = true;
  bool hasPin = false;  ///< filled when read
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
  std::vector<std::string> roles{};  ///< codes
};

inline constexpr const char* kAdministratorRole = "administrator";

[[nodiscard]] inline bool isActiveAdministrator(const UserAccount& user) {
  return user.active &&
         std::find(user.roles.begin(), user.roles.end(), kAdministratorRole) != user.roles.end();
}

/// Outcome of a sign-in attempt.
enum class SignIn {
  kOk,
  kMustChange,  ///< correct, but a new password must be set before anything else
  kWrong,       ///< unknown login or wrong password; deliberately not distinguished
  kWait,        ///< too many failures: the password is not even checked
  kDisabled,    ///< correct, but the account is disabled
  kCodeNeeded,  ///< the password is correct; the account has a second factor, and no code was given
  kCodeWrong,   ///< the password is correct; the code is not, or was used before
  kMustEnrol,   ///< correct, but the centre asks this account for a second factor, which it has not
};

}  // namespace torsio
