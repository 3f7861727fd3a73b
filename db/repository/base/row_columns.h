// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "assessment/domain/rating/instrument.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/insert_idempotent.h"
#include "db/repository/base/stored_term.h"

namespace torsio {

/// A member whose empty text, or 0, is stored as null.
template <typename Member>
struct OrNull {
  Member member;
};
template <typename Member>
OrNull(Member) -> OrNull<Member>;

/// The columns of a table and the members of a record that they hold: one list by which rows are written,
/// read and compared. A ScoreScale takes three columns. Null is read as 0, false, empty text or an empty
/// optional.
template <typename Record, typename... Members>
class RowColumns {
 public:
  constexpr RowColumns(std::string_view table, std::string_view names, Members... members)
      : table_(table), names_(names), members_(members...) {}

  /// Returns the INSERT of all columns; see values().
  [[nodiscard]] std::string insert() const { return insertInto(table_, names_); }
  /// Returns "SELECT x.a, x.b", to be read by operator().
  [[nodiscard]] std::string select(const std::string& alias) const {
    std::string sql;
    for (const std::string& name : columnsOf(names_)) {
      sql.append(sql.empty() ? "SELECT " : ", ").append(alias).append(".").append(name);
    }
    return sql;
  }
  [[nodiscard]] std::vector<Value> values(const Record& record) const {
    std::vector<Value> out;
    std::apply([&](const auto&... member) { (put(out, record, member), ...); }, members_);
    return out;
  }
  /// Inserts a record with insertIdempotent(). `key`, `ignored`: names of those columns, "a, b".
  Inserted insertOnce(Connection& connection, const Record& record, std::string_view key,
                      std::string_view ignored, const Text& what) const {
    using Kind = IdempotentColumn::Kind;
    const std::vector<std::string> names = columnsOf(names_);
    const auto isIn = [](const std::string& name, std::string_view list) {
      const std::vector<std::string> all = columnsOf(list);
      return std::find(all.begin(), all.end(), name) != all.end();
    };
    std::vector<IdempotentColumn> columns;
    for (Value& value : values(record)) {
      const std::string& name = names[columns.size()];
      const Kind kind = isIn(name, key) ? Kind::kKey : isIn(name, ignored) ? Kind::kIgnored : Kind::kContent;
      columns.push_back({name, std::move(value), kind});
    }
    return insertIdempotent(connection, table_, columns, what);
  }
  /// Reads the columns of select().
  [[nodiscard]] Record operator()(RowReader& row) const {
    Record record;
    std::apply([&](const auto&... member) { (take(row, record, member), ...); }, members_);
    return record;
  }

 private:
  template <typename Member>
  static void put(std::vector<Value>& out, const Record& record, const OrNull<Member>& member) {
    const auto& value = record.*member.member;
    out.push_back(value == std::decay_t<decltype(value)>{} ? Value() : Value(value));
  }
  template <typename Kind>
  static void put(std::vector<Value>& out, const Record& record, Kind Record::*member) {
    const Kind& value = record.*member;
    if constexpr (std::is_same_v<Kind, ScoreScale>) {
      out.insert(out.end(), {Value(value.lo), Value(value.hi), Value(value.stepsPerPoint)});
    } else if constexpr (std::is_enum_v<Kind>) {
      out.emplace_back(storedText(value));
    } else {
      out.emplace_back(value);
    }
  }

  template <typename Member>
  void take(RowReader& row, Record& record, const OrNull<Member>& member) const {
    take(row, record, member.member);
  }
  template <typename Kind>
  void take(RowReader& row, Record& record, Kind Record::*member) const {
    Kind& value = record.*member;
    if constexpr (std::is_same_v<Kind, ScoreScale>) {
      value = {row.int64(), row.int64(), row.int64()};
    } else if constexpr (std::is_enum_v<Kind>) {
      value = readTerm<Kind>(row);
    } else if constexpr (std::is_same_v<Kind, bool>) {
      value = row.boolean();
    } else if constexpr (std::is_same_v<Kind, std::int64_t>) {
      value = row.int64();
    } else if constexpr (std::is_same_v<Kind, double>) {
      value = row.real();
    } else if constexpr (std::is_same_v<Kind, std::optional<std::int64_t>>) {
      value = row.maybeInt64();
    } else if constexpr (std::is_same_v<Kind, std::optional<double>>) {
      value = row.maybeReal();
    } else {
      value = row.text();
    }
  }

  std::string_view table_;
  std::string_view names_;
  std::tuple<Members...> members_;
};

/// `names`: "a, b", in the order of the members.
template <typename Record, typename... Members>
[[nodiscard]] constexpr auto rowColumns(std::string_view table, std::string_view names, Members... members) {
  return RowColumns<Record, Members...>(table, names, members...);
}

}  // namespace torsio
