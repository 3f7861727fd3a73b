// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// Reads the current row of a Statement from left to right: each call takes the next column, so that the
/// column list and its reader share one order and no column has a number. Null reads as 0, false or empty;
/// the maybe form preserves it. Valid for one row, in the connection's thread. Taking more columns than there
/// are breaks the contract.
class RowReader {
 public:
  explicit RowReader(const Statement& row) : row_(row) {}

  [[nodiscard]] std::int64_t int64() { return row_.int64(next()); }
  [[nodiscard]] double real() { return row_.real(next()); }
  [[nodiscard]] bool boolean() { return row_.boolean(next()); }
  [[nodiscard]] std::string text() { return row_.text(next()); }
  [[nodiscard]] Blob blob() { return row_.blob(next()); }
  [[nodiscard]] std::optional<std::int64_t> maybeInt64() { return row_.maybeInt64(next()); }
  [[nodiscard]] std::optional<double> maybeReal() { return row_.maybeReal(next()); }
  [[nodiscard]] std::optional<std::string> maybeText() { return row_.maybeText(next()); }
  /// Takes a column; true if it is not null.
  [[nodiscard]] bool hasValue() { return !row_.isNull(next()); }

  /// True if the next column is null; takes none.
  [[nodiscard]] bool nextIsNull() const;
  void skip(int columns);
  /// Returns the name of the column taken last.
  [[nodiscard]] std::string lastName() const { return row_.columnName(column_ - 1); }
  /// True if every column was taken.
  [[nodiscard]] bool atEnd() const { return column_ == row_.columnCount(); }

 private:
  /// Returns the index of the column to take, and advances.
  [[nodiscard]] int next();

  const Statement& row_;
  int column_ = 0;
};

/// Throws ContractError if a reader left columns of its row.
void expectRowTaken(const RowReader& row);

/// Result type of `read` on a RowReader.
template <typename Read>
using RowOf = std::decay_t<std::invoke_result_t<Read&, RowReader&>>;

/// Returns `read(RowReader&)` of the current row; it must take every column.
template <typename Read>
[[nodiscard]] RowOf<Read> readRow(const Statement& statement, Read& read) {
  RowReader row(statement);
  RowOf<Read> made = read(row);
  expectRowTaken(row);
  return made;
}

/// Steps an executed statement to its end and returns `read(RowReader&)` of each row. Throws DbError.
template <typename Read>
[[nodiscard]] std::vector<RowOf<Read>> readRows(Statement& statement, Read&& read) {
  std::vector<RowOf<Read>> rows;
  while (statement.step()) {
    rows.push_back(readRow(statement, read));
  }
  return rows;
}

/// Steps an executed statement once and returns `read(RowReader&)` of that row; empty: no row. Throws
/// DbError.
template <typename Read>
[[nodiscard]] std::optional<RowOf<Read>> readFirst(Statement& statement, Read&& read) {
  if (!statement.step()) {
    return std::nullopt;
  }
  return readRow(statement, read);
}

/// Runs a SELECT with its values and returns `read(RowReader&)` of each row. Throws DbError.
template <typename Read>
[[nodiscard]] auto selectAll(Connection& connection, std::string_view sql, std::span<const Value> values,
                             Read&& read) {
  Statement statement = connection.prepare(sql);
  statement.execute(values);
  return readRows(statement, read);
}

/// Runs a SELECT with its values and returns `read(RowReader&)` of each row. Throws DbError.
template <typename Read>
[[nodiscard]] auto selectAll(Connection& connection, std::string_view sql,
                             std::initializer_list<Value> values, Read&& read) {
  return selectAll(connection, sql, std::span(values.begin(), values.size()), read);
}

/// Runs a SELECT with its values and returns `read(RowReader&)` of its first row; empty: no row. Throws
/// DbError.
template <typename Read>
[[nodiscard]] auto selectFirst(Connection& connection, std::string_view sql,
                               std::initializer_list<Value> values, Read&& read) {
  Statement statement = connection.prepare(sql);
  statement.execute(values);
  return readFirst(statement, read);
}

/// Reads a row with a single text column.
[[nodiscard]] inline std::string readText(RowReader& row) {
  return row.text();
}
/// Reads rows with a single id of this kind.
template <typename Kind>
[[nodiscard]] Kind readId(RowReader& row) {
  return row.text();
}

/// Reads a row with a single integer column.
[[nodiscard]] inline std::int64_t readInt64(RowReader& row) {
  return row.int64();
}

/// Reads a row with a single boolean column.
[[nodiscard]] inline bool readBoolean(RowReader& row) {
  return row.boolean();
}

/// Returns an INSERT statement with one placeholder per column. `columns`: comma-separated names.
[[nodiscard]] std::string insertInto(std::string_view table, std::string_view columns);

}  // namespace torsio
