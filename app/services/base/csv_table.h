// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// One record of a delimited text as it stands.
struct CsvRecord {
  std::size_t line = 0;  ///< on which it begins, from 1
  std::vector<std::string> values{};
};

/// What most probably separates the values: of comma, semicolon and tab the one that stands most often
/// outside quotes in the first line.
[[nodiscard]] char guessSeparator(std::string_view text);

/// Every record, the header too, whatever the number of its values; empty lines are skipped. UTF-8 with or
/// without a byte order mark; quotes after RFC 4180. Throws Error{kBadData} for text that is no UTF-8 and
/// quotes that do not close; `name` stands for the file.
[[nodiscard]] std::vector<CsvRecord> csvRecords(std::string_view text, const std::string& name,
                                                char separator = ',');

/// Returns one line of a table for people and programs: cells as csvCell() writes them, ended by CRLF.
[[nodiscard]] std::string csvLine(const std::vector<std::string>& cells);

/// A table of comma-separated values that knows where each value stands, so that every refusal names file,
/// line, value and rule. RFC 4180 with quotes; UTF-8, a byte order mark is skipped; LF or CRLF; empty lines
/// are skipped; blanks round an unquoted value do not count. The header is required, its columns may come in
/// any order.
class CsvTable {
 public:
  /// Throws Error: kFileMissing, kFileUnreadable; kBadData for a missing header or column, a column named
  /// twice, a line with too few or too many values, quotes that do not close, text that is no UTF-8.
  static CsvTable read(const std::filesystem::path& file, std::initializer_list<std::string_view> required,
                       std::initializer_list<std::string_view> optional = {});
  /// Reads a table from text as read() does from a file; `name` stands for the file in messages.
  static CsvTable parse(std::string_view text, const std::string& name,
                        std::initializer_list<std::string_view> required,
                        std::initializer_list<std::string_view> optional = {});

  [[nodiscard]] std::size_t rows() const noexcept { return rows_.size(); }
  [[nodiscard]] bool has(std::string_view column) const noexcept;
  /// Columns of the file that nobody asked for; a misspelt optional one is among them.
  [[nodiscard]] const std::vector<std::string>& ignored() const noexcept { return ignored_; }

  /// "marks.csv, line 7": the line on which the row begins.
  [[nodiscard]] std::string where(std::size_t row) const;
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// The value as it stands; `column` exists (contract). May be empty.
  [[nodiscard]] const std::string& cell(std::size_t row, std::string_view column) const;
  /// The value of a cell, which may not be empty. Throws Error{kBadData} for an empty one.
  [[nodiscard]] const std::string& text(std::size_t row, std::string_view column) const;
  /// A finite number with a decimal point. Throws Error{kBadData} for an empty value, text, a decimal comma,
  /// NaN, infinity, or a number too large for a double.
  [[nodiscard]] double number(std::size_t row, std::string_view column) const;
  /// Empty where the value is.
  [[nodiscard]] std::optional<double> numberIfGiven(std::size_t row, std::string_view column) const;
  /// A whole number within [low, high].
  [[nodiscard]] std::int64_t whole(std::size_t row, std::string_view column, std::int64_t low,
                                   std::int64_t high) const;

  [[noreturn]] void refuse(std::size_t row, const Text& what, const Text& remedy) const;

 private:
  struct Row {
    std::size_t line = 0;
    std::vector<std::string> values;
  };

  void takeHeader(std::vector<std::string> header, std::size_t line,
                  std::initializer_list<std::string_view> required,
                  std::initializer_list<std::string_view> optional);
  void takeRow(Row row);
  [[nodiscard]] std::size_t position(std::string_view column) const;

  std::string name_;
  std::vector<std::string> header_;
  std::vector<std::string> ignored_;
  std::vector<Row> rows_;
};

}  // namespace torsio
