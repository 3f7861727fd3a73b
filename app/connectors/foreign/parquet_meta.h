// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "app/connectors/foreign/parquet_page.h"
#include "app/connectors/foreign/parquet_thrift.h"

namespace torsio {

/// Where a column of a row group is.
struct ParquetChunk {
  std::int64_t kind = 0;
  std::int64_t codec = 0;
  std::int64_t values = 0;
  std::int64_t dataAt = 0;
  std::int64_t dictionaryAt = 0;
  bool elsewhere = false;  ///< in another file, or encrypted
};

/// What stands before a page. Kinds: 0 and 3 hold values (version 1 and 2), 2 a dictionary.
struct ParquetPage {
  std::int64_t kind = -1;
  std::int64_t unpacked = 0;
  std::int64_t packed = 0;
  std::optional<std::int64_t> checksum{};
  std::int64_t values = 0;
  std::int64_t encoding = -1;
  std::int64_t levelEncoding = 3;
  std::int64_t repetitionEncoding = 3;
  std::int64_t levelBytes = 0;       ///< version 2
  std::int64_t repetitionBytes = 0;  ///< version 2
  bool isPacked = true;              ///< version 2
  std::size_t bytes = 0;             ///< of this head
};

/// Reads the schema: the columns in the order in which row groups list them. Throws ThriftReader::Damaged,
/// for more than 100,000 columns too, as do the others.
[[nodiscard]] std::vector<ParquetLeaf> leavesOf(ThriftReader& in);
[[nodiscard]] ParquetChunk chunkOf(ThriftReader& in);
[[nodiscard]] ParquetPage pageHead(std::string_view bytes);

}  // namespace torsio
