// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/schema_tables.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/field_digest.h"
#include "db/repository/base/row_seal.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr const char* kBookkeeping = "schema_migration";

constexpr const char* kSqliteTables =
    "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%' ORDER BY name";
constexpr const char* kSqliteColumns = "SELECT name, type = 'BOOLEAN' FROM pragma_table_info(?) ORDER BY cid";
constexpr const char* kSqliteReferences =
    "SELECT id, \"from\", \"table\", \"to\" FROM pragma_foreign_key_list(?) ORDER BY id, seq";

constexpr const char* kPostgresqlTables =
    "SELECT tablename FROM pg_tables WHERE schemaname = current_schema() ORDER BY tablename COLLATE \"C\"";
constexpr const char* kPostgresqlColumns =
    "SELECT a.attname, format_type(a.atttypid, -1) = 'boolean' FROM pg_attribute a"
    " JOIN pg_class t ON t.oid = a.attrelid JOIN pg_namespace n ON n.oid = t.relnamespace"
    " WHERE n.nspname = current_schema() AND t.relname = ? AND a.attnum > 0 AND NOT a.attisdropped"
    " ORDER BY a.attnum";
constexpr const char* kPostgresqlReferences =
    "SELECT CAST(c.oid AS BIGINT), a.attname, p.relname, b.attname FROM pg_constraint c"
    " JOIN pg_class t ON t.oid = c.conrelid JOIN pg_class p ON p.oid = c.confrelid"
    " JOIN pg_namespace n ON n.oid = c.connamespace"
    " CROSS JOIN LATERAL unnest(c.conkey, c.confkey) WITH ORDINALITY AS k (child, parent, position)"
    " JOIN pg_attribute a ON a.attrelid = t.oid AND a.attnum = k.child"
    " JOIN pg_attribute b ON b.attrelid = p.oid AND b.attnum = k.parent"
    " WHERE c.contype = 'f' AND n.nspname = current_schema() AND t.relname = ? ORDER BY c.oid, k.position";

bool onSqlite(const Connection& connection) {
  return connection.engine() == Engine::kSqlite;
}

std::size_t positionOf(const SchemaTable& table, const std::string& column) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const TableColumn& part) { return part.name == column; });
  TORSIO_EXPECTS(found != table.columns.end());
  return static_cast<std::size_t>(found - table.columns.begin());
}

SchemaTable describe(Connection& connection, const std::string& name) {
  SchemaTable table{name, {}, {}};
  table.columns = selectAll(connection, onSqlite(connection) ? kSqliteColumns : kPostgresqlColumns, {name},
                            [](RowReader& row) {
                              return TableColumn{row.text(), row.boolean()};
                            });
  std::map<std::int64_t, TableReference> references;
  Statement part = connection.prepare(onSqlite(connection) ? kSqliteReferences : kPostgresqlReferences);
  part.execute({name});
  while (part.step()) {
    RowReader row(part);
    TableReference& reference = references[row.int64()];
    reference.columns.push_back(row.text());
    reference.parent = row.text();
    reference.parentColumns.push_back(row.text());
  }
  for (auto& [id, reference] : references) {
    table.references.push_back(std::move(reference));
  }
  std::stable_sort(table.references.begin(), table.references.end(),
                   [&](const TableReference& a, const TableReference& b) {
                     return positionOf(table, a.columns.front()) < positionOf(table, b.columns.front());
                   });
  return table;
}

/// Adds the little-endian 256-bit number `part` to `sum`.
void addTo(Digest::Value& sum, const Digest::Value& part) {
  unsigned carry = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const unsigned byte = unsigned{sum[i]} + unsigned{part[i]} + carry;
    sum[i] = static_cast<std::uint8_t>(byte & 0xFFU);
    carry = byte >> 8U;
  }
}

}  // namespace

bool SchemaTable::has(const std::string& column) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const TableColumn& part) { return part.name == column; });
}

std::string SchemaTable::columnList() const {
  std::string list;
  for (const TableColumn& column : columns) {
    list.append(list.empty() ? "" : ", ").append(column.name);
  }
  return list;
}

std::vector<SchemaTable> tablesInReferenceOrder(Connection& connection) {
  std::vector<std::string> names =
      selectAll(connection, onSqlite(connection) ? kSqliteTables : kPostgresqlTables, {}, readText);
  std::erase(names, kBookkeeping);
  std::vector<SchemaTable> waiting;
  waiting.reserve(names.size());
  for (const std::string& name : names) {
    waiting.push_back(describe(connection, name));
  }

  std::vector<SchemaTable> ordered;
  std::set<std::string> placed;
  while (!waiting.empty()) {
    const auto next = std::find_if(waiting.begin(), waiting.end(), [&](const SchemaTable& table) {
      return std::all_of(table.references.begin(), table.references.end(), [&](const TableReference& part) {
        return part.parent == table.name || placed.contains(part.parent);
      });
    });
    TORSIO_EXPECTS(next != waiting.end());  // the schema has no cyclic references
    placed.insert(next->name);
    ordered.push_back(std::move(*next));
    waiting.erase(next);
  }
  return ordered;
}

void forEachRow(Connection& connection, const SchemaTable& table, const std::string& where,
                const std::function<void(const Statement&)>& read) {
  forEachSelected(connection, "SELECT " + table.columnList() + " FROM " + table.name + where, read);
}

TableDigest digestOf(Connection& connection, const SchemaTable& table, const std::string& where,
                     const std::function<void()>& step) {
  TableDigest result{table.name, 0, {}};
  Digest::Value sum{};
  forEachRow(connection, table, where, [&](const Statement& row) {
    Digest digest;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      addValue(digest, row.value(static_cast<int>(column)), table.columns[column].boolean);
    }
    addTo(sum, digest.value());
    ++result.rows;
    if (step) {
      step();
    }
  });
  result.hash = toHex(sum);
  return result;
}

}  // namespace torsio
