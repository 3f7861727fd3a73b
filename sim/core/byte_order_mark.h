// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace torsio {

/// What many editors and spreadsheets put before text in UTF-8, and by which spreadsheets recognise it.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

[[nodiscard]] constexpr std::string_view withoutByteOrderMark(std::string_view text) noexcept {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

}  // namespace torsio
