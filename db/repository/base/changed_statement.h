// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torsio {

/// The effect of a repository's INSERT, UPDATE or DELETE as far as its text shows.
struct ChangedStatement {
  enum class Kind { kInsert, kUpdate, kDelete };
  enum class OnConflict { kRefuse, kNothing, kUpdate };
  struct Column {
    std::string name;
    int placeholder = -1;  ///< index of the `?` with its value; -1: computed by the database
  };

  Kind kind = Kind::kInsert;
  std::string table;
  std::vector<Column> columns{};  ///< that it inserts or sets
  OnConflict onConflict = OnConflict::kRefuse;
  std::vector<std::string> replaced{};  ///< columns that an upsert takes from the given row

  std::string where{};  ///< kUpdate: condition of the changed rows; empty: the whole table
  int whereFrom = 0;    ///< index of the first `?` in it

  /// Returns the index of a column's `?`; -1: none.
  [[nodiscard]] int placeholderOf(std::string_view column) const;
};

/// Parses a statement; empty: it changes nothing. Keywords must be upper-case, as in all repositories.
[[nodiscard]] std::optional<ChangedStatement> changedBy(std::string_view sql);

/// Splits "a, b".
[[nodiscard]] std::vector<std::string> columnsOf(std::string_view list);

}  // namespace torsio
