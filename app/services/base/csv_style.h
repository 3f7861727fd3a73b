// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// Format of a table for a spreadsheet. The default suits programs; German Excel reads only its own format:
/// semicolons between cells, commas in numbers.
struct CsvStyle {
  char separator = ',';
  char decimal = '.';
  friend bool operator==(const CsvStyle&, const CsvStyle&) = default;
};

/// Converts a table of csvLine() (or any RFC 4180 text) to another format: separators and quotes, and the
/// decimal mark in cells that are decimal numbers. Keeps a byte order mark. Throws Error{kBadData} if the
/// text is not a table.
[[nodiscard]] std::string csvInStyle(const std::string& text, const CsvStyle& look);

}  // namespace torsio
