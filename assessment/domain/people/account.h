// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"

namespace torsio {

/// How much time and memory one guess costs (Argon2id of libsodium).
enum class PasswordCost {
  kTest,         ///< the least that the library allows: tests only
  kInteractive,  ///< 64 MiB, about 70 ms
  kModerate,     ///< 256 MiB, about 0.4 s
};

/// Somebody who may sign in. No default user and no default password exist.
struct UserAccount {
  UserId id{};
  std::string login{};  ///< unique
  PersonId personId{};  ///< empty: nobody of the record (an administrator, say)
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

/// What came of a try to sign in.
enum class SignIn {
  kOk,
  kMustChange,  ///< right, but nothing else is allowed before a new password is set
  kWrong,       ///< unknown login or wrong password: which of the two is not told
  kWait,        ///< too many failures: not even tried
  kDisabled,    ///< right, but the user was disabled
};

}  // namespace torsio
