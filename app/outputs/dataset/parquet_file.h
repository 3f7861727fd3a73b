// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/outputs/tables/export_table.h"

namespace torsio {

/// The values of a column, one per row; empty: none. Whole numbers are microseconds since 1970 UTC.
using ParquetValues =
    std::variant<std::vector<std::optional<double>>, std::vector<std::optional<std::int64_t>>,
                 std::vector<std::optional<std::string>>>;

struct ParquetColumn {
  std::string name;
  ParquetValues values;
};

/// Returns the columns of a table: numbers as DOUBLE, times as INT64 TIMESTAMP_MICROS in UTC, text as UTF-8.
[[nodiscard]] std::vector<ParquetColumn> parquetColumns(const ExportTable& table);

/// Writes a file in the format of Apache Parquet (version 1): one row group, a page per column, PLAIN values,
/// uncompressed, every column OPTIONAL. Debian has no library for it; npm's hyparquet reads it back in the
/// tests. `facts`: key and value of the file's own metadata. All columns are equally long (contract). Throws
/// Error{kFileUnwritable}, {kBadData} for a column of 2 GB or more.
void writeParquet(const std::filesystem::path& file, const std::vector<ParquetColumn>& columns,
                  const std::vector<std::pair<std::string, std::string>>& facts = {});

}  // namespace torsio
