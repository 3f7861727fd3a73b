// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsio {

/// Text of a file saved by a spreadsheet.
struct RosterText {
  std::string utf8{};      ///< without a byte order mark
  std::string encoding{};  ///< encoding of the file: "UTF-8", "UTF-16", "GB18030", "Windows-1252"
};

/// Decodes UTF-8, UTF-16 with a byte order mark ("Unicode text"), and what older spreadsheets save: GB18030
/// if all non-ASCII characters are byte pairs as in simplified Chinese, otherwise Windows-1252. `name`: file
/// name for messages. Throws Error{kBadData} for any other encoding.
[[nodiscard]] RosterText decodeRosterText(std::string_view bytes, const std::string& name);

}  // namespace torsio
