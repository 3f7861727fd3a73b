// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// Whether a password is one that is tried first: words of the most common passwords, years, digits and signs
/// with hardly a letter of its own, also with 0 for o, @ for a and the like, or a sentence that everybody
/// knows. Works without a network, by a list of its own.
[[nodiscard]] bool isCommonPassword(const std::string& password);

}  // namespace torsio
