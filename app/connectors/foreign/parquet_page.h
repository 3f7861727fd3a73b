// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace torsio {

/// How Parquet stores a value.
enum class ParquetKind : std::uint8_t {
  kBoolean = 0,
  kInt32 = 1,
  kInt64 = 2,
  kInt96 = 3,
  kFloat = 4,
  kDouble = 5,
  kBytes = 6,
  kFixedBytes = 7,
};

/// What a file says of a column.
struct ParquetLeaf {
  /// How its values lie in rows.
  enum class Shape : std::uint8_t {
    kFlat,    ///< one in each row
    kList,    ///< a list in each row
    kGroups,  ///< groups of values, or lists of lists: not read
  };
  std::string name{};  ///< of its outermost group, if it is not flat
  ParquetKind kind = ParquetKind::kDouble;
  Shape shape = Shape::kFlat;
  std::uint32_t given = 0;   ///< definition level of a value; 0: every row has one
  bool mayLackItem = false;  ///< of a list
  bool isText = false;
  bool isUnsigned = false;
  bool isHalf = false;     ///< a half-precision number
  std::int64_t scale = 0;  ///< digits behind the point of a decimal number
  std::string timeUnit{};  ///< "ms", "us", "ns", "days"; empty: not a time
};

struct PageDamaged {};

/// Numbers of a few bits each in Parquet's mixture of runs and packed bits. Throws PageDamaged if it ends too
/// early.
class LevelReader {
 public:
  LevelReader() = default;
  /// `bits`: of each number, at most 32 (contract).
  LevelReader(std::string_view bytes, unsigned bits) : bytes_(bytes), bits_(bits) {}
  [[nodiscard]] std::uint32_t next();

 private:
  void begin();

  std::string_view bytes_;
  unsigned bits_ = 0;
  std::size_t at_ = 0;
  std::uint64_t repeats_ = 0;
  std::uint32_t value_ = 0;
  std::uint64_t packed_ = 0;  ///< numbers left in a packed run
  std::size_t bitAt_ = 0;     ///< from the start of the run at `at_`
};

/// The values of one page, or of a dictionary, one after the other.
class PageValues {
 public:
  PageValues() = default;
  /// PLAIN values. `bytes` must outlive this.
  PageValues(const ParquetLeaf& leaf, std::string_view bytes) : leaf_(&leaf), bytes_(bytes) {}
  /// Returns the next value as text (ParquetTable::next()). Throws PageDamaged if there is none.
  [[nodiscard]] std::string next();

 private:
  template <typename Number>
  [[nodiscard]] Number number();

  const ParquetLeaf* leaf_ = nullptr;
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t bit_ = 0;  ///< of truth values, which take one each
};

}  // namespace torsio
