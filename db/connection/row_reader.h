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

/// Reads the current row of a Statement from left to right: each call takes the next column, so that a list
/// of columns and its reader follow the same order and no column has a number. A null reads as 0, false or
/// empty; the maybe form keeps it. Lives for one row, in the connection's thread. Taking more columns than
/// there are is a broken contract.
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
  /// Takes the column and says whether it holds a value.
  [[nodiscard]] bool hasValue() { return !row_.isNull(next()); }

  /// Whether the next column is null; takes none.
  [[nodiscard]] bool nextIsNull() const;
  /// Leaves out as many columns.
  void skip(int columns);
  /// Whether every column was taken.
  [[nodiscard]] bool atEnd() const { return column_ == row_.columnCount(); }

 private:
  /// The number of the column that is taken now.
  [[nodiscard]] int next();

  const Statement& row_;
  int column_ = 0;
};

/// Throws ContractError when a reader left columns of its row.
void expectRowTaken(const RowReader& row);

/// What `read` makes of a RowReader.
template <typename Read>
using RowOf = std::decay_t<std::invoke_result_t<Read&, RowReader&>>;

/// Makes `read(RowReader&)` of the current row; it takes every column.
template <typename Read>
[[nodiscard]] RowOf<Read> readRow(const Statement& statement, Read& read) {
  RowReader row(statement);
  RowOf<Read> made = read(row);
  expectRowTaken(row);
  return made;
}

/// Steps an executed statement to its end and returns what `read(RowReader&)` makes of each row. Throws
/// DbError.
template <typename Read>
[[nodiscard]] std::vector<RowOf<Read>> readRows(Statement& statement, Read&& read) {
  std::vector<RowOf<Read>> rows;
  while (statement.step()) {
    rows.push_back(readRow(statement, read));
  }
  return rows;
}

/// Steps an executed statement once and returns what `read(RowReader&)` makes of that row; empty: no row.
/// Throws DbError.
template <typename Read>
[[nodiscard]] std::optional<RowOf<Read>> readFirst(Statement& statement, Read&& read) {
  if (!statement.step()) {
    return std::nullopt;
  }
  return readRow(statement, read);
}

/// Runs one SELECT with its values and returns what `read(RowReader&)` makes of each row. Throws DbError.
template <typename Read>
[[nodiscard]] auto selectAll(Connection& connection, std::string_view sql, std::span<const Value> values,
                             Read&& read) {
  Statement statement = connection.prepare(sql);
  statement.execute(values);
  return readRows(statement, read);
}

/// Runs one SELECT with its values and returns what `read(RowReader&)` makes of each row. Throws DbError.
template <typename Read>
[[nodiscard]] auto selectAll(Connection& connection, std::string_view sql,
                             std::initializer_list<Value> values, Read&& read) {
  return selectAll(connection, sql, std::span(values.begin(), values.size()), read);
}

/// Runs one SELECT with its values and returns what `read(RowReader&)` makes of its first row; empty: no row.
/// Throws DbError.
template <typename Read>
[[nodiscard]] auto selectFirst(Connection& connection, std::string_view sql,
                               std::initializer_list<Value> values, Read&& read) {
  Statement statement = connection.prepare(sql);
  statement.execute(values);
  return readFirst(statement, read);
}

/// Reads a row of one text.
[[nodiscard]] inline std::string readText(RowReader& row) {
  return row.text();
}
/// Reads rows of one id of this kind.
template <typename Kind>
[[nodiscard]] Kind readId(RowReader& row) {
  return row.text();
}

/// Reads a row of one whole number.
[[nodiscard]] inline std::int64_t readInt64(RowReader& row) {
  return row.int64();
}

/// Reads a row of one truth value.
[[nodiscard]] inline bool readBoolean(RowReader& row) {
  return row.boolean();
}

/// The text of an INSERT with a placeholder for each column. `columns`: their names, divided by commas.
[[nodiscard]] std::string insertInto(std::string_view table, std::string_view columns);

}  // namespace torsio
