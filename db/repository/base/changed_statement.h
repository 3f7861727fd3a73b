// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torsio {

/// What an INSERT, UPDATE or DELETE of the repositories changes, as far as its text tells.
struct ChangedStatement {
  enum class Kind { kInsert, kUpdate, kDelete };
  enum class OnConflict { kRefuse, kNothing, kUpdate };
  struct Column {
    std::string name;
    int placeholder = -1;  ///< position of the `?` that gives its value; -1: the database computes it
  };

  Kind kind = Kind::kInsert;
  std::string table;
  std::vector<Column> columns{};  ///< that it adds or sets
  OnConflict onConflict = OnConflict::kRefuse;
  std::vector<std::string> replaced{};  ///< columns that kUpdate takes from the row that was given

  std::string where{};  ///< of kUpdate: condition of the rows that it changes; empty: all of the table
  int whereFrom = 0;    ///< position of the first `?` in it

  /// Position of the `?` of a column; -1: none.
  [[nodiscard]] int placeholderOf(std::string_view column) const;
};

/// Empty: changes nothing. Keywords are in capitals, as everywhere in the repositories.
[[nodiscard]] std::optional<ChangedStatement> changedBy(std::string_view sql);

/// "a, b" as a list.
[[nodiscard]] std::vector<std::string> columnsOf(std::string_view list);

}  // namespace torsio
