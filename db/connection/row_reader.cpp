// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/row_reader.h"

#include <algorithm>

#include "sim/core/contracts.h"

namespace torsio {

int RowReader::next() {
  TORSIO_EXPECTS(column_ < row_.columnCount());
  return column_++;
}

bool RowReader::nextIsNull() const {
  TORSIO_EXPECTS(column_ < row_.columnCount());
  return row_.isNull(column_);
}

void RowReader::skip(int columns) {
  TORSIO_EXPECTS(columns >= 0 && columns <= row_.columnCount() - column_);
  column_ += columns;
}

void expectRowTaken(const RowReader& row) {
  TORSIO_EXPECTS(row.atEnd());
}

std::string insertInto(std::string_view table, std::string_view columns) {
  std::string sql = "INSERT INTO ";
  sql.append(table).append(" (").append(columns).append(") VALUES (?");
  for (auto more = std::count(columns.begin(), columns.end(), ','); more > 0; --more) {
    sql += ", ?";
  }
  return sql + ")";
}

}  // namespace torsio
