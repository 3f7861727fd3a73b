// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace torsio {

/// Reads Thrift's compact protocol, in which Parquet describes itself, from bytes that nobody vouches for.
/// Every call throws Damaged for bytes that end too early, a length or a count that does not fit into what is
/// left, and structs nested too deeply. Nothing is copied.
class ThriftReader {
 public:
  struct Damaged {};
  /// Kinds of a value as the protocol numbers them.
  enum Kind : unsigned {
    kTrue = 1,
    kFalse,
    kByte,
    kI16,
    kI32,
    kI64,
    kDouble,
    kBinary,
    kList,
    kSet,
    kMap,
    kStruct
  };
  struct List {
    std::size_t size = 0;
    unsigned kind = 0;
  };

  explicit ThriftReader(std::string_view bytes) : bytes_(bytes) {}

  /// Calls `take(number, kind)` for each field of a struct; it reads the value and returns true, or returns
  /// false to skip it.
  template <typename Take>
  void fields(const Take& take) {
    int number = 0;
    for (unsigned kind = 0; nextField(number, kind);) {
      if (!take(number, kind)) {
        skip(kind, 0);
      }
    }
  }
  /// A number of any size.
  [[nodiscard]] std::int64_t whole();
  [[nodiscard]] std::string_view text();
  [[nodiscard]] List list();
  void skip(unsigned kind, int depth = 0);
  [[nodiscard]] std::size_t at() const noexcept { return at_; }

 private:
  bool nextField(int& number, unsigned& kind);
  [[nodiscard]] unsigned byte();
  [[nodiscard]] std::uint64_t varint();
  [[nodiscard]] std::size_t left() const noexcept { return bytes_.size() - at_; }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace torsio
