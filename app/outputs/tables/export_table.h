// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "assessment/results/ledger.h"
#include "sim/core/text.h"

namespace torsio {

enum class ColumnKind {
  kText,
  kNumber,  ///< double; whole numbers too
  kTime,    ///< microseconds since 1970 UTC, as std::int64_t
};

/// A column of an exported table.
struct ExportColumn {
  std::string name;  ///< for programs: lower-case ASCII letters, digits and underscores; unique within the
                     ///< table
  Text title;        ///< for readers
  ColumnKind kind = ColumnKind::kText;
  std::string unit{};                             ///< "N m"; empty: none
  std::vector<std::pair<double, Text>> labels{};  ///< meaning of particular values
  std::vector<Text> order{};  ///< of a text column: its values in their order; empty: none
};

/// monostate: no value.
using ExportValue = std::variant<std::monostate, std::string, double, std::int64_t>;
struct ExportCell : ExportValue {
  using ExportValue::ExportValue;
  std::shared_ptr<const ResultKey> key{};  ///< of its result; null: none
};

/// Plain values with their meaning; the source of every file format.
struct ExportTable {
  std::string name;  ///< format as for a column
  Text title;
  Text source;  ///< one sentence on what its numbers are calculated from
  std::vector<ExportColumn> columns;
  std::vector<std::vector<ExportCell>> rows;  ///< each as long as `columns`
};

/// Rounds to 15 significant digits, the precision of spreadsheets.
[[nodiscard]] double sheetNumber(double value);

/// Formats a cell for programs: numbers in full precision, times as "2026-01-05T08:00:00.125000Z".
[[nodiscard]] std::string cellText(const ExportCell& cell);

}  // namespace torsio
