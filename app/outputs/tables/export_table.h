// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

enum class ColumnKind {
  kText,
  kNumber,  ///< double; whole numbers too
  kTime,    ///< microseconds since 1970 UTC, as std::int64_t
};

/// A column of a table that leaves the house.
struct ExportColumn {
  std::string name;  ///< for programs: lower-case ASCII letters, digits and underscores; unique in its table
  Text title;        ///< for people
  ColumnKind kind = ColumnKind::kText;
  std::string unit{};                             ///< "N m"; empty: none
  std::vector<std::pair<double, Text>> labels{};  ///< what single numbers stand for
};

/// Empty where there is no value.
using ExportCell = std::variant<std::monostate, std::string, double, std::int64_t>;

/// Plain values with their meaning, from which every file format is written.
struct ExportTable {
  std::string name;  ///< as of a column
  Text title;
  Text source;  ///< what its numbers are made of, in a sentence
  std::vector<ExportColumn> columns;
  std::vector<std::vector<ExportCell>> rows;  ///< each as long as columns
};

/// Returns the nearest number of 15 significant digits, which is what spreadsheets keep.
[[nodiscard]] double sheetNumber(double value);

/// Returns a cell as text for programs: numbers with all their digits, times as
/// "2026-01-05T08:00:00.125000Z".
[[nodiscard]] std::string cellText(const ExportCell& cell);

}  // namespace torsio
