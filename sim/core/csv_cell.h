// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsio {

/// Returns a cell quoted after RFC 4180 where it holds a quote, a line end or one of `separators`.
[[nodiscard]] std::string csvQuoted(std::string text, std::string_view separators);

/// Returns one cell of a table for people and programs: quoted after RFC 4180 where it holds a separator
/// (comma or semicolon), a quote or a line end. Text that a spreadsheet would take for a formula gets an
/// apostrophe in front; a number stays as it is.
[[nodiscard]] std::string csvCell(std::string text);
/// Writes the same to the end of `line`.
void appendCsvCell(std::string& line, const std::string& text);

}  // namespace torsio
