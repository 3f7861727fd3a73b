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

/// One record of a delimited text.
struct CsvRecord {
  std::size_t line = 0;  ///< its first line, from 1
  std::vector<std::string> values{};
};

/// Guesses the separator: the most frequent of comma, semicolon and tab outside quotes in the first line.
[[nodiscard]] char guessSeparator(std::string_view text);

/// Returns all records including the header, with any number of values; skips empty lines. UTF-8 with or
/// without a byte order mark; quotes as in RFC 4180. Throws Error{kBadData} for invalid UTF-8 and unclosed
/// quotes; `name`: file name for messages.
[[nodiscard]] std::vector<CsvRecord> csvRecords(std::string_view text, const std::string& name,
                                                char separator = ',');

/// Returns one line of a table for people and programs: cells in csvCell() format, ended by CRLF.
[[nodiscard]] std::string csvLine(const std::vector<std::string>& cells);

/// A table of comma-separated values with positions, so that every error names file, line, value and rule.
/// RFC 4180 with quotes; UTF-8; skips a byte order mark and empty lines; LF or CRLF; ignores spaces around
/// unquoted values. The header is required, with columns in any order.
class CsvTable {
 public:
  /// Throws Error: kFileMissing, kFileUnreadable; kBadData for a missing header or column, a duplicate
  /// column, a line with too few or too many values, unclosed quotes, invalid UTF-8, and for identifiers
  /// (columns such as subject, rater, group) that cannot be read or look alike (Identifiers).
  static CsvTable read(const std::filesystem::path& file, std::initializer_list<std::string_view> required,
                       std::initializer_list<std::string_view> optional = {});
  /// Parses a table like read(); `name`: file name for messages.
  static CsvTable parse(std::string_view text, const std::string& name,
                        std::initializer_list<std::string_view> required,
                        std::initializer_list<std::string_view> optional = {});

  [[nodiscard]] std::size_t rows() const noexcept { return rows_.size(); }
  [[nodiscard]] bool has(std::string_view column) const noexcept;
  /// Returns the columns that were not asked for, including misspelt optional ones.
  [[nodiscard]] const std::vector<std::string>& ignored() const noexcept { return ignored_; }

  /// Returns a sentence for each identifier that a spreadsheet seems to have turned into a number.
  [[nodiscard]] const std::vector<Text>& damaged() const noexcept { return damaged_; }

  /// Returns "marks.csv, line 7", with the first line of the row.
  [[nodiscard]] std::string where(std::size_t row) const;
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// Returns the unparsed value, possibly empty; `column` must exist (contract).
  [[nodiscard]] const std::string& cell(std::size_t row, std::string_view column) const;
  /// Returns a value. Throws Error{kBadData} if empty.
  [[nodiscard]] const std::string& text(std::size_t row, std::string_view column) const;
  /// Returns a finite number with a decimal point. Throws Error{kBadData} for an empty value, text, a decimal
  /// comma, NaN, infinity, or a number too large for a double.
  [[nodiscard]] double number(std::size_t row, std::string_view column) const;
  /// Returns empty if the value is empty.
  [[nodiscard]] std::optional<double> numberIfGiven(std::size_t row, std::string_view column) const;
  /// Returns a whole number within [low, high].
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
  void checkIdentifiers();
  [[nodiscard]] std::size_t position(std::string_view column) const;

  std::string name_;
  std::vector<std::string> header_;
  std::vector<std::string> ignored_;
  std::vector<Text> damaged_;
  std::vector<Row> rows_;
};

}  // namespace torsio
