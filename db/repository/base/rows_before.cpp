// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/rows_before.h"

#include <algorithm>
#include <optional>

#include "db/connection/row_reader.h"
#include "db/repository/base/sealed_row.h"

namespace torsio {

namespace {

/// Condition, with its values, of the rows that a statement changes.
struct RowChoice {
  std::string condition;
  std::vector<Value> values;
};

std::optional<RowChoice> choiceOf(const SealRule& rule, const ChangedStatement& change,
                                  std::span<const Value> bound) {
  if (change.kind == ChangedStatement::Kind::kUpdate) {
    const auto first = std::min(static_cast<std::size_t>(change.whereFrom), bound.size());
    const std::span<const Value> values = bound.subspan(first);
    return RowChoice{change.where, {values.begin(), values.end()}};
  }
  if (change.kind != ChangedStatement::Kind::kInsert ||
      change.onConflict != ChangedStatement::OnConflict::kUpdate) {
    return std::nullopt;
  }
  RowChoice choice;
  for (const std::string& column : columnsOf(rule.key)) {
    const int placeholder = change.placeholderOf(column);
    if (placeholder < 0) {
      return std::nullopt;
    }
    choice.condition += (choice.condition.empty() ? "" : " AND ") + column + " = ?";
    choice.values.push_back(bound[static_cast<std::size_t>(placeholder)]);
  }
  return choice;
}

}  // namespace

std::vector<RowBefore> rowsBefore(Connection& connection, const SealRule& rule,
                                  const ChangedStatement& change, std::span<const Value> bound) {
  if (rule.sealing != Sealing::kEachChange) {
    return {};
  }
  const std::optional<RowChoice> choice = choiceOf(rule, change, bound);
  if (!choice) {
    return {};
  }
  const std::string table(rule.table);
  Statement select = connection.prepare("SELECT * FROM " + table +
                                        (choice->condition.empty() ? "" : " WHERE " + choice->condition) +
                                        (connection.engine() == Engine::kPostgresql ? " FOR UPDATE" : ""));
  select.execute(choice->values);
  std::vector<std::vector<Value>> rows;
  std::optional<SealShape> shape;
  while (select.step()) {
    if (!shape) {
      shape.emplace(rule, columnNamesOf(select));
    }
    rows.push_back(valuesOf(select));
  }
  std::vector<RowBefore> found;
  for (const std::vector<Value>& row : rows) {
    std::string salt;
    if (shape->hasPersonal(row)) {
      salt = selectFirst(connection, "SELECT salt FROM seal_salt WHERE table_name = ? AND row_key = ?",
                         {table, shape->keyOf(row)}, readText)
                 .value_or("");
    }
    found.push_back({shape->keyValuesOf(row), sealOf(shape->kept(row), {}) + shape->personal(row, salt)});
  }
  return found;
}

}  // namespace torsio
