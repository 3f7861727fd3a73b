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
  bool boolean = false;  ///< SQLite returns such a value as 0 or 1
};

/// Columns of a table that refer to another one.
struct TableReference {
  std::vector<std::string> columns;
  std::string parent;
  std::vector<std::string> parentColumns;
};

/// A table as described by the engine.
struct SchemaTable {
  std::string name;
  std::vector<TableColumn> columns;
  /// By the position of their first column; the first one is the parent.
  std::vector<TableReference> references;

  [[nodiscard]] bool has(const std::string& column) const;
  /// Returns "a, b, c".
  [[nodiscard]] std::string columnList() const;
};

/// Returns the tables of a record except schema_migration, parents before children, otherwise by name.
/// References to the same table are ignored.
[[nodiscard]] std::vector<SchemaTable> tablesInReferenceOrder(Connection& connection);

/// Calls `read` for every row of a table, unordered, with columns as in `table.columns`, fetching some
/// hundred rows at a time. `where`: " WHERE ..." or empty. Inside a transaction only.
void forEachRow(Connection& connection, const SchemaTable& table, const std::string& where,
                const std::function<void(const Statement&)>& read);

/// Number of rows of a table, and a hash of them that is independent of engine and order.
struct TableDigest {
  std::string table;
  std::int64_t rows = 0;
  std::string hash;  ///< sum modulo 2^256 of the BLAKE2b-256 of each row, 64 hexadecimal digits
  friend bool operator==(const TableDigest&, const TableDigest&) = default;
};

/// Computes the digest of a table inside a transaction; `step` is called after every row.
[[nodiscard]] TableDigest digestOf(Connection& connection, const SchemaTable& table,
                                   const std::string& where = {}, const std::function<void()>& step = {});

}  // namespace torsio
