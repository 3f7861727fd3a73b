// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/changed_statement.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "db/connection/row_reader.h"
#include "db/repository/base/row_seal.h"

namespace torsio {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) {
    text.remove_prefix(1);
  }
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) {
    text.remove_suffix(1);
  }
  return text;
}

/// Scans a statement from left to right.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(trimmed(text)) {}

  bool take(std::string_view words) {
    if (!rest_.starts_with(words)) {
      return false;
    }
    rest_ = trimmed(rest_.substr(words.size()));
    return true;
  }
  std::string_view word() {
    const std::size_t end = std::min(rest_.find_first_of(" (\n"), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_ = trimmed(rest_.substr(end));
    return word;
  }
  /// Returns the comma-separated items outside brackets and quotes, up to a closing bracket or `stop`.
  std::vector<std::string_view> items(std::string_view stop) {
    std::vector<std::string_view> found;
    std::size_t begin = 0;
    std::size_t at = 0;
    int depth = 0;
    for (bool quoted = false; at < rest_.size(); ++at) {
      const char letter = rest_[at];
      quoted = quoted != (letter == '\'');
      if (quoted) {
        continue;
      }
      if (depth == 0 && (letter == ')' || (!stop.empty() && rest_.substr(at).starts_with(stop)))) {
        break;
      }
      depth += letter == '(' ? 1 : letter == ')' ? -1 : 0;
      if (letter == ',' && depth == 0) {
        found.push_back(trimmed(rest_.substr(begin, at - begin)));
        begin = at + 1;
      }
    }
    found.push_back(trimmed(rest_.substr(begin, at - begin)));
    rest_ = trimmed(rest_.substr(std::min(at + 1, rest_.size())));
    return found;
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// Returns the placeholder of an expression; `next`: index of the next one.
int placeholderIn(std::string_view expression, int& next) {
  if (expression == "?") {
    return next++;
  }
  next += static_cast<int>(std::count(expression.begin(), expression.end(), '?'));
  return -1;
}

ChangedStatement insertion(Reader& reader) {
  ChangedStatement change;
  change.kind = ChangedStatement::Kind::kInsert;
  change.table = reader.word();
  if (reader.take("(")) {
    for (const std::string_view name : reader.items({})) {
      change.columns.push_back({std::string(name)});
    }
  }
  int next = 0;
  if (reader.take("VALUES (")) {
    const std::vector<std::string_view> expressions = reader.items({});
    for (std::size_t i = 0; i < expressions.size() && i < change.columns.size(); ++i) {
      change.columns[i].placeholder = placeholderIn(expressions[i], next);
    }
  }
  if (!reader.take("ON CONFLICT (")) {
    return change;
  }
  (void)reader.items({});
  if (!reader.take("DO UPDATE SET")) {
    change.onConflict = ChangedStatement::OnConflict::kNothing;
    return change;
  }
  change.onConflict = ChangedStatement::OnConflict::kUpdate;
  for (const std::string_view item : reader.items(" WHERE ")) {
    const std::string_view name = trimmed(item.substr(0, item.find('=')));
    if (trimmed(item.substr(item.find('=') + 1)) == "excluded." + std::string(name)) {
      change.replaced.emplace_back(name);
    }
  }
  return change;
}

ChangedStatement update(Reader& reader) {
  ChangedStatement change;
  change.kind = ChangedStatement::Kind::kUpdate;
  change.table = reader.word();
  int next = 0;
  if (reader.take("SET")) {
    for (const std::string_view item : reader.items(" WHERE ")) {
      const std::size_t equals = item.find('=');
      const int placeholder = placeholderIn(trimmed(item.substr(equals + 1)), next);
      change.columns.push_back({std::string(trimmed(item.substr(0, equals))), placeholder});
    }
  }
  change.whereFrom = next;
  if (reader.take("WHERE")) {
    change.where = reader.rest();
  }
  return change;
}

}  // namespace

int ChangedStatement::placeholderOf(std::string_view column) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& candidate) { return candidate.name == column; });
  return found == columns.end() ? -1 : found->placeholder;
}

std::optional<ChangedStatement> changedBy(std::string_view sql) {
  Reader reader(sql);
  if (reader.take("INSERT INTO ")) {
    return insertion(reader);
  }
  if (reader.take("UPDATE ")) {
    return update(reader);
  }
  if (reader.take("DELETE FROM ")) {
    return ChangedStatement{.kind = ChangedStatement::Kind::kDelete, .table = std::string(reader.word())};
  }
  return std::nullopt;
}

std::vector<std::string> columnsOf(std::string_view list) {
  std::vector<std::string> columns;
  for (const std::string_view name : Reader(list).items({})) {
    if (!name.empty()) {
      columns.emplace_back(name);
    }
  }
  return columns;
}

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
