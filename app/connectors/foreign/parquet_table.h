// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace torsio {

/// Returns whether a file begins as a Parquet file does; false if it cannot be read.
[[nodiscard]] bool isParquet(const std::filesystem::path& file);

/// Some columns of a Parquet file, row by row. Reads columns of numbers, truth values and text, and items of
/// columns with a list of these in each row; PLAIN and dictionary encoding; pages of version 1 and 2, as they
/// are or packed with Snappy, gzip or zstd; checksums are verified. Holds a page of each column and its
/// dictionary in memory, whatever the file says of itself.
class ParquetTable {
 public:
  /// Reads what the file says of its columns. `name`: of the file, for messages; `columns`: names of those to
  /// read, or of items of lists, counted from 0: "state[3]". Throws Error: kFileMissing, kFileUnreadable;
  /// kBadData, with file, column and what to do, if it is no Parquet file, is damaged or encrypted, has more
  /// than 50 million rows, or a column is missing, has groups of values or is of a kind that is not read.
  ParquetTable(const std::filesystem::path& file, std::string name, const std::vector<std::string>& columns);
  ~ParquetTable();
  ParquetTable(const ParquetTable&) = delete;
  ParquetTable& operator=(const ParquetTable&) = delete;

  /// Fills `cells` with the next row: numbers with all their digits, true as 1, an empty cell as "". Returns
  /// false after the last row. Throws Error{kBadData} for damaged pages, for encodings, packings and
  /// sizes of pages that are not read, and for a list that is too short for an item.
  bool next(std::vector<std::string>& cells);
  /// Returns the unit that the file itself gives the numbers of a column of times: "ms", "us", "ns", "days";
  /// empty: none. `column`: position in the list of columns.
  [[nodiscard]] std::string timeUnit(std::size_t column) const;

 private:
  class Reader;
  std::unique_ptr<Reader> reader_;
};

}  // namespace torsio
