// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/csv_writer.h"

#include <ostream>

#include "sim/base/contracts.h"
#include "sim/base/file_io.h"

namespace torsio {

namespace {

void writeField(std::ostream& out, const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) {
    out << field;
    return;
  }
  out << '"';
  for (const char c : field) {
    if (c == '"') out << '"';
    out << c;
  }
  out << '"';
}

void writeRow(std::ostream& out, const std::vector<std::string>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) out << ',';
    writeField(out, row[i]);
  }
  out << "\r\n";
}

}  // namespace

void writeCsv(const std::filesystem::path& file, const std::vector<std::string>& columns,
              const std::vector<std::vector<std::string>>& rows) {
  for (const auto& row : rows) TORSIO_EXPECTS(row.size() == columns.size());
  writeFileAtomically(file, [&](std::ostream& out) {
    writeRow(out, columns);
    for (const auto& row : rows) writeRow(out, row);
  });
}

}  // namespace torsio
