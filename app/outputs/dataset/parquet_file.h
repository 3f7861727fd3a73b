// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/outputs/tables/export_table.h"

namespace torsio {

/// A list of the same length in each row.
template <typename Value>
struct ParquetLists {
  std::size_t length = 1;       ///< at least 1
  std::vector<Value> values{};  ///< row by row, a multiple of `length`
};

/// The values of a column, one per row; empty: none. Whole numbers that may be empty are microseconds since
/// 1970 UTC, others are whole numbers.
using ParquetValues =
    std::variant<std::vector<std::optional<double>>, std::vector<std::optional<std::int64_t>>,
                 std::vector<std::optional<std::string>>, std::vector<float>, std::vector<std::int64_t>,
                 ParquetLists<float>, ParquetLists<double>, ParquetLists<std::int64_t>,
                 ParquetLists<std::string>>;

struct ParquetColumn {
  std::string name;
  ParquetValues values;
};

/// Returns the columns of a table: numbers as DOUBLE, times as INT64 TIMESTAMP_MICROS in UTC, text as UTF-8.
[[nodiscard]] std::vector<ParquetColumn> parquetColumns(const ExportTable& table);

/// A file in the format of Apache Parquet (version 1), made row group by row group: a page per column and
/// group, PLAIN values, uncompressed, every column OPTIONAL. Debian has no library for it; npm's hyparquet
/// reads it back in the tests.
class ParquetFile {
 public:
  ParquetFile();

  /// Adds a row group. All columns are equally long, and the same in each group (contract). Throws
  /// Error{kBadData} for a column of 2 GB or more.
  void add(const std::vector<ParquetColumn>& columns);
  /// Returns the bytes so far.
  [[nodiscard]] std::size_t bytes() const noexcept { return text_.size(); }
  /// Writes the file, which has at least one group (contract). `facts`: key and value of its own metadata.
  /// Throws Error{kFileUnwritable}.
  void write(const std::filesystem::path& file,
             const std::vector<std::pair<std::string, std::string>>& facts = {}) &&;

 private:
  std::string text_;
  std::int64_t rows_ = 0;
  std::vector<std::string> schema_;  ///< structs of Thrift
  std::vector<std::string> groups_;
};

/// Writes a ParquetFile of one row group. Throws as it does.
void writeParquet(const std::filesystem::path& file, const std::vector<ParquetColumn>& columns,
                  const std::vector<std::pair<std::string, std::string>>& facts = {});

}  // namespace torsio
