// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <memory>
#include <readstat.h>
#include <string>

#include "app/outputs/tables/table_files.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kSpssEpoch_s = 12'219'379'200;  // from 1582-10-14 to 1970-01-01
constexpr std::size_t kLongestText = 32'767;           // bytes that SPSS keeps

/// Writes one table; turns errors of the library into errors that name the table.
class SpssWriter {
 public:
  SpssWriter(const ExportTable& table, std::ostream& out) : table_(table), out_(out) {
    readstat_set_data_writer(writer_.get(), [](const void* bytes, size_t size, void* self) {
      auto& stream = static_cast<SpssWriter*>(self)->out_;
      stream.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
      return stream ? static_cast<ssize_t>(size) : ssize_t{-1};
    });
    readstat_writer_set_compression(writer_.get(), READSTAT_COMPRESS_ROWS);
    check(readstat_writer_set_file_label(writer_.get(), table.title.str().c_str()));
  }

  void write() {
    std::vector<readstat_variable_t*> variables;
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      variables.push_back(variable(c));
    }
    check(readstat_begin_writing_sav(writer_.get(), this, static_cast<long>(table_.rows.size())));
    for (const readstat_variable_t* one : variables) {
      check(readstat_validate_variable(writer_.get(), one));
    }
    for (const auto& row : table_.rows) {
      check(readstat_begin_row(writer_.get()));
      for (std::size_t c = 0; c < row.size(); ++c) {
        insert(variables[c], row[c]);
      }
      check(readstat_end_row(writer_.get()));
    }
    check(readstat_end_writing(writer_.get()));
  }

 private:
  readstat_variable_t* variable(std::size_t c) {
    const ExportColumn& column = table_.columns[c];
    const bool text = column.kind == ColumnKind::kText;
    std::size_t width = 1;
    for (const auto& row : table_.rows) {
      if (const auto* words = std::get_if<std::string>(&row[c])) {
        width = std::max(width, std::min(words->size(), kLongestText));
      }
    }
    readstat_variable_t* made =
        readstat_add_variable(writer_.get(), column.name.c_str(),
                              text ? READSTAT_TYPE_STRING : READSTAT_TYPE_DOUBLE, text ? width : 0);
    const std::string label = column.title.str() + (column.unit.empty() ? "" : ", " + column.unit);
    readstat_variable_set_label(made, label.c_str());
    const bool coded = !column.labels.empty();
    readstat_variable_set_measure(made, text    ? READSTAT_MEASURE_NOMINAL
                                        : coded ? READSTAT_MEASURE_ORDINAL
                                                : READSTAT_MEASURE_SCALE);
    if (column.kind == ColumnKind::kTime) {
      readstat_variable_set_format(made, "DATETIME24.3");
    }
    if (coded) {
      readstat_label_set_t* labels =
          readstat_add_label_set(writer_.get(), READSTAT_TYPE_DOUBLE, column.name.c_str());
      for (const auto& [value, words] : column.labels) {
        readstat_label_double_value(labels, value, words.str().c_str());
      }
      readstat_variable_set_label_set(made, labels);
    }
    return made;
  }

  void insert(const readstat_variable_t* variable, const ExportCell& cell) {
    if (const auto* words = std::get_if<std::string>(&cell)) {
      check(readstat_insert_string_value(writer_.get(), variable, words->substr(0, kLongestText).c_str()));
    } else if (const auto* number = std::get_if<double>(&cell)) {
      check(readstat_insert_double_value(writer_.get(), variable, *number));
    } else if (const auto* utc_us = std::get_if<std::int64_t>(&cell)) {
      check(readstat_insert_double_value(
          writer_.get(), variable, static_cast<double>(*utc_us) * 1e-6 + static_cast<double>(kSpssEpoch_s)));
    } else {
      check(readstat_insert_missing_value(writer_.get(), variable));
    }
  }

  void check(readstat_error_t error) const {
    if (error != READSTAT_OK) {
      throw Error(ErrorCode::kBadData, Text::tr("the table does not fit an SPSS file"),
                  Text(table_.name + ": " + readstat_error_message(error)), "");
    }
  }

  const ExportTable& table_;
  std::ostream& out_;
  std::unique_ptr<readstat_writer_t, decltype(&readstat_writer_free)> writer_{readstat_writer_init(),
                                                                              &readstat_writer_free};
};

}  // namespace

void writeSpssFile(const ExportTable& table, const fs::path& file) {
  writeFileAtomically(file, [&](std::ostream& out) { SpssWriter(table, out).write(); });
}

}  // namespace torsio
