// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsio {

/// The text of a file that a spreadsheet saved.
struct RosterText {
  std::string utf8{};      ///< without a byte order mark
  std::string encoding{};  ///< as it was saved: "UTF-8", "UTF-16", "GB18030", "Windows-1252"
};

/// Reads UTF-8, UTF-16 with a byte order mark ("Unicode text"), and what older spreadsheets save: GB18030
/// where every letter that is not ASCII is a pair of bytes as in simplified Chinese, else Windows-1252.
/// `name`: of the file, for messages. Throws Error{kBadData} for what is none of these.
[[nodiscard]] RosterText decodeRosterText(std::string_view bytes, const std::string& name);

}  // namespace torsio
