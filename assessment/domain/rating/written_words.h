// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

// How much a rater may write, in characters (code points of Unicode).
inline constexpr std::size_t kLongestRemark = 400;      ///< at a moment of a recording
inline constexpr std::size_t kLongestReason = 200;      ///< of an amendment, of "not assessable"
inline constexpr std::size_t kLongestComment = 10'000;  ///< of a sheet

/// Checks words that somebody wrote. Throws Error{kBadParameter}, `where` its place: longer than `longest`
/// characters, not UTF-8, or with a control character other than a tab and the end of a line. Empty ones
/// pass.
void requireWords(std::string_view words, std::size_t longest, const Text& where);

}  // namespace torsio
