// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

inline constexpr std::size_t kLongestNumber = 64;  ///< characters of a staff or student number
inline constexpr std::size_t kLongestLogin = 64;   ///< characters of a sign-in name
inline constexpr std::size_t kLongestField = 200;  ///< characters of a name, an address, a level, a post

/// Says why a text about a person cannot be taken: too long, or with a character that nobody sees (controls,
/// line ends, marks that turn the direction of writing, blanks without width, fillers). Empty: it can.
[[nodiscard]] Text flawOf(std::string_view text, std::size_t longest);

/// Returns what a reader takes a number or a sign-in name for: wide and accented forms, the several dashes
/// and blanks, the digits of all scripts, Cyrillic, Greek and Armenian letters that look like Latin ones, O
/// and 0, and upper case all become one. Two that differ and look alike would make two people of one, or one
/// of two.
[[nodiscard]] std::string likenessOf(std::string_view number);

}  // namespace torsio
