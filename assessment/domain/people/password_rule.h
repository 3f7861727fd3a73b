// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// Length matters, composition does not: digits and capitals are neither required nor forbidden.
inline constexpr int kShortestPassword = 15;   ///< characters, not bytes
inline constexpr int kLongestPassword = 1024;  ///< bytes
inline constexpr int kShortestPin = 4;

/// Checks a new password. Throws Error{kBadParameter} with a plain reason: too short, too long, one repeated
/// character or short pattern, derived from the login name, or common (isCommonPassword).
void checkPassword(const std::string& password, const std::string& login);

}  // namespace torsio
