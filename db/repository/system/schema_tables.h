// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace torsio {

class Connection;
class Statement;

struct TableColumn {
  std::string name;
  bool boolean = false;  ///< SQLite gives such a value back as 0 or 1
};

/// Columns of a table that name a row of another one.
struct TableReference {
  std::vector<std::string> columns;
  std::string parent;
  std::vector<std::string> parentColumns;
};

/// A table as the engine describes it.
struct SchemaTable {
  std::string name;
  std::vector<TableColumn> columns;
  /// By the position of their first column: the first one says to what a row belongs.
  std::vector<TableReference> references;

  [[nodiscard]] bool has(const std::string& column) const;
  /// "a, b, c"
  [[nodiscard]] std::string columnList() const;
};

/// The tables of a record but schema_migration, parents before their children, else by name. A table that
/// refers to itself stands where its other references put it.
[[nodiscard]] std::vector<SchemaTable> tablesInReferenceOrder(Connection& connection);

/// Calls `read` for every row of a table, in no particular order, with its columns in the order of
/// `table.columns`. Never holds more than some hundred rows in memory. `where`: " WHERE ..." or empty. Inside
/// a transaction only.
void forEachRow(Connection& connection, const SchemaTable& table, const std::string& where,
                const std::function<void(const Statement&)>& read);

/// How many rows a table has, and a hash over them that does not depend on the engine or on their order.
struct TableDigest {
  std::string table;
  std::int64_t rows = 0;
  std::string hash;  ///< sum modulo 2^256 of the BLAKE2b-256 of each row, 64 hexadecimal digits
  friend bool operator==(const TableDigest&, const TableDigest&) = default;
};

/// Inside a transaction only. `step` is called after every row.
[[nodiscard]] TableDigest digestOf(Connection& connection, const SchemaTable& table,
                                   const std::string& where = {}, const std::function<void()>& step = {});

}  // namespace torsio
