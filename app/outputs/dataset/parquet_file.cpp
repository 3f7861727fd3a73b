// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://parquet.apache.org/docs/file-format. Numbers of fields and kinds below are those of its
// parquet.thrift, written in Thrift's compact protocol.
#include "app/outputs/dataset/parquet_file.h"

#include <array>
#include <bit>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr std::string_view kMagic = "PAR1";

enum class Thrift : std::uint8_t { kI32 = 5, kI64 = 6, kBinary = 8, kList = 9, kStruct = 12 };

void putVarint(std::string& out, std::uint64_t value) {
  constexpr std::uint64_t kSevenBits = 0x7F;
  while (value > kSevenBits) {
    out.push_back(static_cast<char>((value & kSevenBits) | 0x80U));
    value >>= 7U;
  }
  out.push_back(static_cast<char>(value));
}

template <typename Number>
void putLittleEndian(std::string& out, Number value) {
  static_assert(std::endian::native == std::endian::little);
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A struct of the compact protocol; fields in the order of their numbers.
class ThriftStruct {
 public:
  ThriftStruct& whole(int field, std::int64_t value, Thrift kind = Thrift::kI32) {
    head(field, kind);
    putVarint(text_, zigzag(value));
    return *this;
  }
  ThriftStruct& text(int field, std::string_view value) {
    head(field, Thrift::kBinary);
    putVarint(text_, value.size());
    text_.append(value);
    return *this;
  }
  ThriftStruct& part(int field, const ThriftStruct& value) {
    head(field, Thrift::kStruct);
    text_.append(value.ended());
    return *this;
  }
  /// `values`: structs that are ended().
  ThriftStruct& parts(int field, const std::vector<std::string>& values) {
    list(field, Thrift::kStruct, values.size());
    for (const std::string& value : values) {
      text_.append(value);
    }
    return *this;
  }
  ThriftStruct& wholes(int field, const std::vector<std::int64_t>& values) {
    list(field, Thrift::kI32, values.size());
    for (const std::int64_t value : values) {
      putVarint(text_, zigzag(value));
    }
    return *this;
  }
  ThriftStruct& texts(int field, const std::vector<std::string>& values) {
    list(field, Thrift::kBinary, values.size());
    for (const std::string& value : values) {
      putVarint(text_, value.size());
      text_.append(value);
    }
    return *this;
  }
  [[nodiscard]] std::string ended() const { return text_ + '\0'; }

 private:
  static std::uint64_t zigzag(std::int64_t value) {
    return (static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63);
  }
  void head(int field, Thrift kind) {
    TORSIO_EXPECTS(field > last_ && field - last_ < 16);
    text_.push_back(
        static_cast<char>(static_cast<unsigned>(field - last_) << 4U | static_cast<unsigned>(kind)));
    last_ = field;
  }
  void list(int field, Thrift of, std::size_t size) {
    constexpr std::size_t kShort = 15;
    head(field, Thrift::kList);
    const auto kind = static_cast<unsigned>(of);
    if (size < kShort) {
      text_.push_back(static_cast<char>(static_cast<unsigned>(size) << 4U | kind));
    } else {
      text_.push_back(static_cast<char>(0xF0U | kind));
      putVarint(text_, size);
    }
  }
  std::string text_;
  int last_ = 0;
};

// Kinds of parquet.thrift.
constexpr std::int64_t kInt64 = 2;
constexpr std::int64_t kFloat = 4;
constexpr std::int64_t kDouble = 5;
constexpr std::int64_t kByteArray = 6;
constexpr std::int64_t kOptional = 1;
constexpr std::int64_t kRepeated = 2;
constexpr std::int64_t kUtf8 = 0;
constexpr std::int64_t kList = 3;
constexpr std::int64_t kTimestampMicros = 10;
constexpr std::int64_t kPlain = 0;
constexpr std::int64_t kRle = 3;
constexpr int kOfListElements = 3;  // level of a value inside a list, which is optional as its elements are

std::int64_t kindOf(float) {
  return kFloat;
}
std::int64_t kindOf(double) {
  return kDouble;
}
std::int64_t kindOf(std::int64_t) {
  return kInt64;
}
std::int64_t kindOf(const std::string&) {
  return kByteArray;
}

template <typename Number>
void putPlain(std::string& out, Number value) {
  putLittleEndian(out, value);
}
void putPlain(std::string& out, const std::string& value) {
  putLittleEndian(out, static_cast<std::uint32_t>(value.size()));
  out.append(value);
}

/// Appends `count` times the same level.
void putRun(std::string& out, std::size_t count, int level) {
  putVarint(out, count << 1U);
  out.push_back(static_cast<char>(level));
}

std::string withLength(const std::string& levels) {
  std::string out;
  putLittleEndian(out, static_cast<std::uint32_t>(levels.size()));
  return out + levels;
}

/// What the writer has to know of a kind of column.
template <typename Values>
struct Column;

/// Each row has a value or none.
template <typename Value>
struct Column<std::vector<std::optional<Value>>> {
  using Of = Value;
  static constexpr bool kLists = false;
  static constexpr bool kTime = std::is_same_v<Value, std::int64_t>;
  static std::size_t rows(const std::vector<std::optional<Value>>& values) { return values.size(); }
  static std::size_t leaves(const std::vector<std::optional<Value>>& values) { return values.size(); }
  /// The body of a data page: which rows have a value, in runs, then these values.
  static std::string page(const std::vector<std::optional<Value>>& values) {
    std::string runs;
    std::string plain;
    for (std::size_t i = 0; i < values.size();) {
      std::size_t next = i;
      while (next < values.size() && values[next].has_value() == values[i].has_value()) {
        if (values[next]) {
          putPlain(plain, *values[next]);
        }
        ++next;
      }
      putRun(runs, next - i, values[i] ? 1 : 0);
      i = next;
    }
    return withLength(runs) + plain;
  }
};

/// Each row has a value.
template <typename Value>
struct Column<std::vector<Value>> {
  using Of = Value;
  static constexpr bool kLists = false;
  static constexpr bool kTime = false;
  static std::size_t rows(const std::vector<Value>& values) { return values.size(); }
  static std::size_t leaves(const std::vector<Value>& values) { return values.size(); }
  static std::string page(const std::vector<Value>& values) {
    std::string runs;
    putRun(runs, values.size(), 1);
    std::string out = withLength(runs);
    for (const Value& value : values) {
      putPlain(out, value);
    }
    return out;
  }
};

/// Each row has a list of the same length: a bit per value says whether it goes on with the list.
template <typename Value>
struct Column<ParquetLists<Value>> {
  using Of = Value;
  static constexpr bool kLists = true;
  static constexpr bool kTime = false;
  static std::size_t rows(const ParquetLists<Value>& lists) { return lists.values.size() / lists.length; }
  static std::size_t leaves(const ParquetLists<Value>& lists) { return lists.values.size(); }
  static std::string page(const ParquetLists<Value>& lists) {
    constexpr std::size_t kBits = 8;
    const std::size_t count = lists.values.size();
    std::string goesOn((count + kBits - 1) / kBits, '\0');
    for (std::size_t i = 0; i < count; ++i) {
      if (i % lists.length != 0) {
        goesOn[i / kBits] =
            static_cast<char>(static_cast<unsigned char>(goesOn[i / kBits]) | 1U << i % kBits);
      }
    }
    std::string bits;
    putVarint(bits, goesOn.size() << 1U | 1U);
    std::string runs;
    putRun(runs, count, kOfListElements);
    std::string out = withLength(bits + goesOn) + withLength(runs);
    for (const Value& value : lists.values) {
      putPlain(out, value);
    }
    return out;
  }
};

/// Calls `with` with the values of a column and their traits.
template <typename With>
auto ofColumn(const ParquetColumn& column, const With& with) {
  return std::visit(
      [&](const auto& values) { return with(values, Column<std::decay_t<decltype(values)>>()); },
      column.values);
}

std::size_t lengthOf(const ParquetColumn& column) {
  return ofColumn(column, [](const auto& values, const auto& traits) { return traits.rows(values); });
}

/// Appends the elements of the schema that a column takes, from its root to its values.
void addSchema(const ParquetColumn& column, std::vector<std::string>& schema) {
  ofColumn(column, [&](const auto&, const auto& traits) {
    using Traits = std::decay_t<decltype(traits)>;
    if (Traits::kLists) {
      schema.push_back(
          ThriftStruct().whole(3, kOptional).text(4, column.name).whole(5, 1).whole(6, kList).ended());
      schema.push_back(ThriftStruct().whole(3, kRepeated).text(4, "list").whole(5, 1).ended());
    }
    const std::int64_t kind = kindOf(typename Traits::Of());
    ThriftStruct value;
    value.whole(1, kind).whole(3, kOptional).text(4, Traits::kLists ? "element" : column.name);
    if (kind == kByteArray || Traits::kTime) {
      value.whole(6, kind == kByteArray ? kUtf8 : kTimestampMicros);
    }
    schema.push_back(value.ended());
  });
}

}  // namespace

std::vector<ParquetColumn> parquetColumns(const ExportTable& table) {
  std::vector<ParquetColumn> columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto valuesAs = [&]<typename Value>(Value) {
      std::vector<std::optional<Value>> values;
      for (const std::vector<ExportCell>& row : table.rows) {
        const auto* value = std::get_if<Value>(&static_cast<const ExportValue&>(row[c]));
        values.push_back(value != nullptr ? std::optional(*value) : std::nullopt);
      }
      return ParquetValues(std::move(values));
    };
    const ColumnKind kind = table.columns[c].kind;
    columns.push_back({table.columns[c].name, kind == ColumnKind::kNumber ? valuesAs(double())
                                              : kind == ColumnKind::kTime ? valuesAs(std::int64_t())
                                                                          : valuesAs(std::string())});
  }
  return columns;
}

ParquetFile::ParquetFile() : text_(kMagic) {}

void ParquetFile::add(const std::vector<ParquetColumn>& columns) {
  TORSIO_EXPECTS(!columns.empty());
  const std::size_t rows = lengthOf(columns.front());
  const bool first = schema_.empty();
  if (first) {
    schema_.push_back(ThriftStruct().text(4, "schema").whole(5, std::ssize(columns)).ended());
  }
  std::vector<std::string> chunks;
  const auto groupBegin = std::ssize(text_);
  for (const ParquetColumn& column : columns) {
    TORSIO_EXPECTS(lengthOf(column) == rows);
    if (first) {
      addSchema(column, schema_);
    }
    ofColumn(column, [&](const auto& values, const auto& traits) {
      using Traits = std::decay_t<decltype(traits)>;
      const std::string page = traits.page(values);
      if (page.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
        refuse(Text::tr("a column has more than 2 GB: %1", column.name), column.name,
               Text::tr("Export fewer lines a second"));
      }
      const auto leaves = static_cast<std::int64_t>(traits.leaves(values));
      ThriftStruct about;
      about.whole(1, leaves).whole(2, kPlain).whole(3, kRle).whole(4, kRle);
      ThriftStruct head;
      head.whole(1, 0).whole(2, std::ssize(page)).whole(3, std::ssize(page)).part(5, about);
      const auto begin = std::ssize(text_);
      text_ += head.ended() + page;
      const std::int64_t bytes = std::ssize(text_) - begin;
      ThriftStruct chunk;
      chunk.whole(1, kindOf(typename Traits::Of()))
          .wholes(2, {kPlain, kRle})
          .texts(3, Traits::kLists ? std::vector<std::string>{column.name, "list", "element"}
                                   : std::vector<std::string>{column.name})
          .whole(4, 0)
          .whole(5, leaves, Thrift::kI64)
          .whole(6, bytes, Thrift::kI64)
          .whole(7, bytes, Thrift::kI64)
          .whole(9, begin, Thrift::kI64);
      chunks.push_back(ThriftStruct().whole(2, begin, Thrift::kI64).part(3, chunk).ended());
    });
  }
  groups_.push_back(ThriftStruct()
                        .parts(1, chunks)
                        .whole(2, std::ssize(text_) - groupBegin, Thrift::kI64)
                        .whole(3, static_cast<std::int64_t>(rows), Thrift::kI64)
                        .ended());
  rows_ += static_cast<std::int64_t>(rows);
}

void ParquetFile::write(const std::filesystem::path& file,
                        const std::vector<std::pair<std::string, std::string>>& facts) && {
  TORSIO_EXPECTS(!groups_.empty());
  ThriftStruct all;
  all.whole(1, 1).parts(2, schema_).whole(3, rows_, Thrift::kI64).parts(4, groups_);
  if (!facts.empty()) {
    std::vector<std::string> pairs;
    for (const auto& [key, value] : facts) {
      pairs.push_back(ThriftStruct().text(1, key).text(2, value).ended());
    }
    all.parts(5, pairs);
  }
  all.text(6, "torsio");
  const std::string footer = all.ended();
  text_ += footer;
  putLittleEndian(text_, static_cast<std::uint32_t>(footer.size()));
  text_ += kMagic;
  writeFileAtomically(file, text_);
}

void writeParquet(const std::filesystem::path& file, const std::vector<ParquetColumn>& columns,
                  const std::vector<std::pair<std::string, std::string>>& facts) {
  ParquetFile whole;
  whole.add(columns);
  std::move(whole).write(file, facts);
}

}  // namespace torsio
