// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

// Limits on raters' free text, in characters (Unicode code points).
inline constexpr std::size_t kLongestRemark = 400;      ///< at a moment of a recording
inline constexpr std::size_t kLongestReason = 200;      ///< of an amendment or a "not assessable"
inline constexpr std::size_t kLongestComment = 10'000;  ///< of a sheet

/// Checks free text; empty text passes. Throws Error{kBadParameter} naming `where`: longer than `longest`
/// characters, not UTF-8, or with a control character other than tab and newline.
void requireWords(std::string_view words, std::size_t longest, const Text& where);

}  // namespace torsio
