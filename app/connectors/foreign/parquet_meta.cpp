// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of fields and kinds are those of parquet.thrift.
#include "app/connectors/foreign/parquet_meta.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace torsio {

namespace {

constexpr std::size_t kMaxColumns = 100'000;
constexpr std::int64_t kOptionalField = 1;
constexpr std::int64_t kRepeatedField = 2;

/// What is understood of an element of the schema.
struct SchemaElement {
  ParquetLeaf leaf{};
  std::optional<std::int64_t> kind{};
  std::int64_t repetition = 0;
  std::int64_t children = 0;
};

/// The older word for what the numbers mean.
void hearConverted(std::int64_t word, ParquetLeaf& leaf) {
  constexpr std::int64_t kUtf8 = 0, kEnum = 4, kDate = 6, kFirstMillis = 7, kLastMicros = 10,
                         kFirstUnsigned = 11, kLastUnsigned = 14, kJson = 19;
  leaf.isText = leaf.isText || word == kUtf8 || word == kEnum || word == kJson;
  leaf.isUnsigned = leaf.isUnsigned || (word >= kFirstUnsigned && word <= kLastUnsigned);
  if (word == kDate) {
    leaf.timeUnit = "days";
  } else if (word >= kFirstMillis &&
             word <= kLastMicros) {  // time and time stamp, in milliseconds and microseconds
    leaf.timeUnit = word % 2 != 0 ? "ms" : "us";
  }
}

/// The newer word: a union, whose field says which.
void hearLogical(ThriftReader& in, ParquetLeaf& leaf) {
  constexpr int kString = 1, kDecimal = 5, kDate = 6, kTime = 7, kTimestamp = 8, kInteger = 10, kJson = 12,
                kHalf = 15;
  in.fields([&](int which, unsigned kind) {
    if (kind != ThriftReader::kStruct) {
      return false;
    }
    leaf.isText = leaf.isText || which == kString || which == kJson;
    leaf.isHalf = leaf.isHalf || which == kHalf;
    if (which == kDate) {
      leaf.timeUnit = "days";
    }
    in.fields([&](int field, unsigned type) {
      if (which == kInteger && field == 2) {
        leaf.isUnsigned = type == ThriftReader::kFalse;
      } else if (which == kDecimal && field == 1) {
        leaf.scale = in.whole();
        return true;
      } else if ((which == kTime || which == kTimestamp) && field == 2 && type == ThriftReader::kStruct) {
        in.fields([&](int unit, unsigned) {
          leaf.timeUnit = unit == 1 ? "ms" : unit == 2 ? "us" : "ns";
          return false;
        });
        return true;
      }
      return false;
    });
    return true;
  });
}

SchemaElement schemaElement(ThriftReader& in) {
  SchemaElement element;
  in.fields([&](int field, unsigned) {
    switch (field) {
      case 1:
        element.kind = in.whole();
        return true;
      case 3:
        element.repetition = in.whole();
        return true;
      case 4:
        element.leaf.name = in.text();
        return true;
      case 5:
        element.children = in.whole();
        return true;
      case 6:
        hearConverted(in.whole(), element.leaf);
        return true;
      case 7:
        element.leaf.scale = in.whole();
        return true;
      case 10:
        hearLogical(in, element.leaf);
        return true;
      default:
        return false;
    }
  });
  constexpr std::int64_t kLastKind = 7;
  const std::int64_t kind = element.kind.value_or(0);
  if (element.children < 0 || kind < 0 || kind > kLastKind) {
    throw ThriftReader::Damaged();
  }
  element.leaf.kind = static_cast<ParquetKind>(kind);
  return element;
}

/// A group of columns whose end is still to come.
struct SchemaGroup {
  std::string name;
  std::int64_t repetition = 0;
  std::int64_t childrenLeft = 0;
  bool single = false;  ///< has one child
};

/// Says how the values of a column lie in rows. `around`: the groups around it, outermost first.
void shape(std::span<const SchemaGroup> around, SchemaElement& element) {
  ParquetLeaf& leaf = element.leaf;
  std::uint32_t repeated = element.repetition == kRepeatedField ? 1 : 0;
  leaf.given = element.repetition == kOptionalField || repeated == 1 ? 1 : 0;
  bool single = true;
  for (const SchemaGroup& group : around) {
    repeated += group.repetition == kRepeatedField ? 1 : 0;
    leaf.given += group.repetition == kOptionalField || group.repetition == kRepeatedField ? 1 : 0;
    single = single && group.single;
  }
  leaf.mayLackItem = element.repetition == kOptionalField;
  leaf.shape = around.empty() && repeated == 0 ? ParquetLeaf::Shape::kFlat
               : single && repeated == 1       ? ParquetLeaf::Shape::kList
                                               : ParquetLeaf::Shape::kGroups;
  if (!around.empty()) {
    leaf.name = around.front().name;
  }
}

}  // namespace

std::vector<ParquetLeaf> leavesOf(ThriftReader& in) {
  const ThriftReader::List all = in.list();
  std::vector<ParquetLeaf> leaves;
  std::vector<SchemaGroup> open;  // the file itself first
  for (std::size_t i = 0; i < all.size; ++i) {
    SchemaElement element = schemaElement(in);
    if (i > 0) {
      while (!open.empty() && open.back().childrenLeft == 0) {
        open.pop_back();
      }
      if (open.empty()) {
        throw ThriftReader::Damaged();
      }
      --open.back().childrenLeft;
    }
    if (i == 0 || !element.kind) {
      open.push_back(SchemaGroup{std::move(element.leaf.name), element.repetition, element.children,
                                 element.children == 1});
      continue;
    }
    shape(std::span(open).subspan(1), element);
    leaves.push_back(std::move(element.leaf));
    if (leaves.size() > kMaxColumns) {
      throw ThriftReader::Damaged();
    }
  }
  return leaves;
}

ParquetChunk chunkOf(ThriftReader& in) {
  ParquetChunk chunk;
  in.fields([&](int field, unsigned) {
    chunk.elsewhere = chunk.elsewhere || field == 1 || field == 8;
    if (field != 3) {
      return false;
    }
    in.fields([&](int inner, unsigned) {
      switch (inner) {
        case 1:
          chunk.kind = in.whole();
          return true;
        case 4:
          chunk.codec = in.whole();
          return true;
        case 5:
          chunk.values = in.whole();
          return true;
        case 9:
          chunk.dataAt = in.whole();
          return true;
        case 11:
          chunk.dictionaryAt = in.whole();
          return true;
        default:
          return false;
      }
    });
    return true;
  });
  return chunk;
}

ParquetPage pageHead(std::string_view bytes) {
  ThriftReader in(bytes);
  ParquetPage head;
  in.fields([&](int field, unsigned) {
    switch (field) {
      case 1:
        head.kind = in.whole();
        return true;
      case 2:
        head.unpacked = in.whole();
        return true;
      case 3:
        head.packed = in.whole();
        return true;
      case 4:
        head.checksum = in.whole();
        return true;
      case 5:
      case 7:
        in.fields([&](int inner, unsigned) {
          std::int64_t* const to = inner == 1                 ? &head.values
                                   : inner == 2               ? &head.encoding
                                   : inner == 3 && field == 5 ? &head.levelEncoding
                                   : inner == 4 && field == 5 ? &head.repetitionEncoding
                                                              : nullptr;
          if (to != nullptr) {
            *to = in.whole();
          }
          return to != nullptr;
        });
        return true;
      case 8:
        in.fields([&](int inner, unsigned type) {
          std::int64_t* const to = inner == 1   ? &head.values
                                   : inner == 4 ? &head.encoding
                                   : inner == 5 ? &head.levelBytes
                                   : inner == 6 ? &head.repetitionBytes
                                                : nullptr;
          if (to != nullptr) {
            *to = in.whole();
          } else if (inner == 7) {
            head.isPacked = type == ThriftReader::kTrue;
          }
          return to != nullptr;
        });
        return true;
      default:
        return false;
    }
  });
  head.bytes = in.at();
  return head;
}

}  // namespace torsio
