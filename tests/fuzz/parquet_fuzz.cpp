// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a Parquet file of which three columns are read: the result must be an Error or rows. The first
// byte selects the columns, so that numbers, text and dictionaries of each sample are reached.
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/connectors/foreign/parquet_table.h"
#include "sim/core/error.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const torsio::fuzz::FuzzFile kFile(".parquet");
  static const std::array<std::vector<std::string>, 3> kColumns{
      {{"recording", "rater", "score"}, {"t_ms", "x", "jaw"}, {"note", "y", "qz"}}};
  if (size == 0) {
    return 0;
  }
  const std::vector<std::string>& columns = kColumns.at(data[0] % kColumns.size());
  try {
    torsio::ParquetTable table(kFile.holding(torsio::fuzz::textOf(data + 1, size - 1)), "f", columns);
    std::vector<std::string> cells;
    constexpr int kMaxRows = 5'000;
    for (int row = 0; row < kMaxRows && table.next(cells); ++row) {
      if (cells.size() != columns.size()) {
        std::abort();
      }
    }
  } catch (const torsio::Error&) {
  }
  return 0;
}
