// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/connectors/foreign/parquet_meta.h"
#include "app/connectors/foreign/parquet_page.h"
#include "sim/core/text.h"

// One column of a Parquet file, page by page. Private to this folder. The format:
// https://parquet.apache.org/docs/file-format. Numbers of kinds are those of its parquet.thrift.
namespace torsio {

/// Throws Error{kBadData}. `where`: file, or file and column.
[[noreturn]] void refuseDamagedParquet(const std::string& where);

/// The bytes of a Parquet file.
class ParquetBytes {
 public:
  /// `name`: for messages. Throws Error{kFileMissing, kFileUnreadable}.
  ParquetBytes(const std::filesystem::path& file, std::string name);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] std::string placeOf(const ParquetLeaf& leaf) const { return name_ + ", " + leaf.name; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// Where the pages end; at first that of the file.
  [[nodiscard]] std::size_t dataEnd() const noexcept { return dataEnd_; }
  void endDataAt(std::size_t at) noexcept { dataEnd_ = at; }
  /// Throws Error{kBadData} beyond the end.
  [[nodiscard]] std::string bytesAt(std::size_t at, std::size_t count);

 private:
  std::string name_;
  std::ifstream in_;
  std::size_t size_ = 0;
  std::size_t dataEnd_ = 0;
};

/// A column that is read. Holds one page and its dictionary.
class ParquetColumnReader {
 public:
  ParquetColumnReader(ParquetBytes& file, ParquetLeaf leaf) : file_(&file), leaf_(std::move(leaf)) {}

  [[nodiscard]] const ParquetLeaf& leaf() const noexcept { return leaf_; }
  /// Begins a row group of `rows` rows. Throws Error{kBadData}, as next() does.
  void begin(const ParquetChunk& chunk, std::int64_t rows);
  /// Reads the next row: the values of its list, or the value of a flat column, as text; empty: none.
  void next();
  /// Returns an item of the row's list, from 0; 0 for a flat column. Empty for a row without a list. Throws
  /// Error{kBadData} for an item beyond the list.
  [[nodiscard]] const std::string& item(std::size_t index) const;

 private:
  [[nodiscard]] bool isList() const noexcept { return leaf_.shape == ParquetLeaf::Shape::kList; }
  void readRow();
  /// Reads an entry of the current row.
  void readEntry();
  [[nodiscard]] std::string valueOf();
  /// Returns whether the current row goes on.
  [[nodiscard]] bool goesOn();
  /// Reads a page; a page without values (a dictionary, an index) leaves none.
  void nextPage();
  void takeDictionary(const ParquetPage& head, const std::string& bytes);
  void beginValues(const ParquetPage& head, std::size_t levels);
  /// Takes the levels of a page of version 1 from the front.
  [[nodiscard]] std::string_view levelsOf(std::int64_t encoding, std::string_view& bytes) const;
  [[noreturn]] void refuseHere(const Text& what, const Text& remedy) const;
  [[noreturn]] void refuseEncoding(std::int64_t encoding) const;

  ParquetBytes* file_;
  ParquetLeaf leaf_;
  std::int64_t codec_ = 0;
  std::size_t at_ = 0;           ///< of the next page in the file
  std::int64_t valuesLeft_ = 0;  ///< in pages to come
  std::int64_t inPage_ = 0;
  std::vector<std::string> dictionary_;
  std::string page_;
  std::vector<std::string> row_;
  std::optional<std::uint32_t> ahead_;  ///< repetition level of the next entry, if it was read
  LevelReader repeats_;                 ///< whether an entry goes on with the list
  LevelReader given_;                   ///< whether there is a value
  std::optional<LevelReader> numbers_;  ///< in the dictionary, or truth values; empty: PLAIN
  PageValues plain_;
};

}  // namespace torsio
