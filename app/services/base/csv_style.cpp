// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/csv_style.h"

#include <algorithm>
#include <string_view>

#include "app/services/base/csv_table.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/csv_cell.h"

namespace torsio {

namespace {

bool isFigure(char c) {
  return c >= '0' && c <= '9';
}

/// Returns the position of the point in "-12.5" and "1.5e-7"; npos for other cells.
std::size_t pointOf(std::string_view cell) {
  std::size_t at = cell.starts_with('-') || cell.starts_with("'-") ? cell.find('-') + 1 : 0;
  const auto skipDigits = [&] {
    const std::size_t begin = at;
    while (at < cell.size() && isFigure(cell[at])) {
      ++at;
    }
    return at > begin;
  };
  if (!skipDigits() || at >= cell.size() || cell[at] != '.') {
    return std::string_view::npos;
  }
  const std::size_t point = at++;
  if (!skipDigits()) {
    return std::string_view::npos;
  }
  if (at < cell.size() && (cell[at] == 'e' || cell[at] == 'E')) {
    ++at;
    at += at < cell.size() && (cell[at] == '-' || cell[at] == '+') ? 1 : 0;
    if (!skipDigits()) {
      return std::string_view::npos;
    }
  }
  return at == cell.size() ? point : std::string_view::npos;
}

std::string cellIn(std::string cell, const CsvStyle& look) {
  if (const std::size_t point = pointOf(cell); point != std::string::npos) {
    cell[point] = look.decimal;
  }
  return csvQuoted(std::move(cell), std::string_view(&look.separator, 1));
}

}  // namespace

std::string csvInStyle(const std::string& text, const CsvStyle& look) {
  if (look == CsvStyle{}) {
    return text;
  }
  std::string out(text.starts_with(kByteOrderMark) ? kByteOrderMark : std::string_view());
  for (const CsvRecord& record : csvRecords(text, "table")) {
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      if (i > 0) {
        out += look.separator;
      }
      out += cellIn(record.values[i], look);
    }
    out += "\r\n";
  }
  return out;
}

}  // namespace torsio
