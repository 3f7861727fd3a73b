// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

inline constexpr std::size_t kLongestNumber = 64;  ///< characters of a staff or student number
inline constexpr std::size_t kLongestLogin = 64;   ///< characters of a sign-in name
inline constexpr std::size_t kLongestField = 200;  ///< characters of a name, address, level or post

/// Returns why a text about a person is rejected: too long, or with an invisible character (controls, line
/// ends, direction marks, zero-width spaces, fillers). Empty: accepted.
[[nodiscard]] Text flawOf(std::string_view text, std::size_t longest);

/// Returns a canonical form for comparing numbers and sign-in names by appearance: unifies wide and accented
/// forms, dashes and spaces, digits of all scripts, Cyrillic, Greek and Armenian letters that look like Latin
/// ones, O and 0, and case. Look-alikes would split one person into two, or merge two people.
[[nodiscard]] std::string likenessOf(std::string_view number);

}  // namespace torsio
