// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/insert_idempotent.h"

#include <vector>

#include "db/connection/db_error.h"

namespace torsio {

namespace {

void appendListed(std::string& text, std::string_view item) {
  if (!text.empty()) {
    text += ", ";
  }
  text += item;
}

/// True if the stored row with this key has this content.
bool isThere(Connection& connection, std::string_view table, std::span<const IdempotentColumn> columns) {
  std::string select;
  std::string where;
  std::vector<Value> key;
  for (const IdempotentColumn& column : columns) {
    if (column.kind == IdempotentColumn::Kind::kContent) {
      appendListed(select, column.name);
    }
    if (column.kind != IdempotentColumn::Kind::kKey) {
      continue;
    }
    where += (where.empty() ? "" : " AND ") + std::string(column.name) + " = ?";
    key.push_back(column.value);
  }
  Statement row = connection.prepare("SELECT " + select + " FROM " + std::string(table) + " WHERE " + where);
  row.execute(key);
  if (!row.step()) {
    return false;
  }
  int position = 0;
  for (const IdempotentColumn& column : columns) {
    if (column.kind != IdempotentColumn::Kind::kContent) {
      continue;
    }
    if (!sameStored(column.value, row.value(position++))) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool sameStored(const Value& given, const Value& read) {
  const auto* flag = std::get_if<bool>(&given.storage());
  const auto* number = std::get_if<std::int64_t>(&read.storage());
  if (flag != nullptr && number != nullptr) {
    return *number == (*flag ? 1 : 0);
  }
  return given.storage() == read.storage();
}

void refuseOtherContent(Connection& connection, std::string_view table, const Text& what) {
  throw DbError(DbFault::kUnique, "INSERT INTO " + std::string(table),
                Text::tr("%1 is already stored with different content; the stored version is kept", what),
                connection.location(), Text::tr("Keep what you have here and compare the two"));
}

Inserted insertIdempotent(Connection& connection, std::string_view table,
                          std::span<const IdempotentColumn> columns, const Text& what) {
  std::string names;
  std::string marks;
  std::string key;
  std::vector<Value> values;
  for (const IdempotentColumn& column : columns) {
    appendListed(names, column.name);
    appendListed(marks, "?");
    if (column.kind == IdempotentColumn::Kind::kKey) {
      appendListed(key, column.name);
    }
    values.push_back(column.value);
  }
  Statement insert = connection.prepare("INSERT INTO " + std::string(table) + " (" + names + ") VALUES (" +
                                        marks + ") ON CONFLICT (" + key + ") DO NOTHING");
  insert.execute(values);
  if (insert.affectedRows() == 1) {
    return Inserted::kNew;
  }
  if (!isThere(connection, table, columns)) {
    refuseOtherContent(connection, table, what);
  }
  return Inserted::kThereAlready;
}

}  // namespace torsio
