// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// How a table is written for the spreadsheet that will open it. The default is what programs read; German
/// Excel opens a file of its own country only: semicolons between the cells, a comma in the numbers.
struct CsvStyle {
  char separator = ',';
  char decimal = '.';
  friend bool operator==(const CsvStyle&, const CsvStyle&) = default;
};

/// Writes a table of csvLine() (or of any RFC 4180 text) in another look: cells are parted and quoted anew,
/// and in cells that are a decimal number and nothing else the decimal mark is changed. A byte order mark
/// stays. Throws Error{kBadData} when the text is no table.
[[nodiscard]] std::string csvInStyle(const std::string& text, const CsvStyle& look);

}  // namespace torsio
