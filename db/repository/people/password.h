// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assessment/people/account.h"

namespace torsio {

/// Length counts, composition does not: no digit or capital is asked for, none is forbidden.
inline constexpr int kShortestPassword = 15;   ///< characters, not bytes
inline constexpr int kLongestPassword = 1024;  ///< bytes
inline constexpr int kShortestPin = 4;

/// Throws Error (kBadParameter) with a plain reason: too short, too long, one character or a short pattern
/// over and over, or made of the login name.
void checkPassword(const std::string& password, const std::string& login);

/// Salted hash with its parameters, as one text. Runs off the GUI thread. Throws Error (kInternal) without
/// memory.
[[nodiscard]] std::string hashPassword(const std::string& password, PasswordCost cost);

[[nodiscard]] bool passwordMatches(const std::string& hash, const std::string& password);

}  // namespace torsio
