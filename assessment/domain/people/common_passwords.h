// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// True for a password that an attacker tries first: common words, years, digits and signs with hardly a
/// letter of its own, the same with 0 for o, @ for a and the like, or a well-known passphrase. Uses a
/// built-in list, no network.
[[nodiscard]] bool isCommonPassword(const std::string& password);

}  // namespace torsio
