// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assessment/domain/people/account.h"

namespace torsio {

/// Returns a salted hash with its parameters as one text. Slow: call it off the GUI thread. Throws Error
/// (kInternal) without memory.
[[nodiscard]] std::string hashPassword(const std::string& password, PasswordCost cost);

[[nodiscard]] bool passwordMatches(const std::string& hash, const std::string& password);

}  // namespace torsio
