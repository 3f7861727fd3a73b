// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// Length counts, composition does not: no digit or capital is asked for, none is forbidden.
inline constexpr int kShortestPassword = 15;   ///< characters, not bytes
inline constexpr int kLongestPassword = 1024;  ///< bytes
inline constexpr int kShortestPin = 4;

/// Checks a new password. Throws Error{kBadParameter} with a plain reason: too short, too long, one character
/// or a short pattern over and over, made of the login name, or a common one (isCommonPassword).
void checkPassword(const std::string& password, const std::string& login);

}  // namespace torsio
