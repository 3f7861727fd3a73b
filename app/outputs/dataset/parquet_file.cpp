// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://parquet.apache.org/docs/file-format. Numbers of fields and kinds below are those of its
// parquet.thrift, written in Thrift's compact protocol.
#include "app/outputs/dataset/parquet_file.h"

#include <array>
#include <bit>
#include <limits>
#include <string_view>

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
  ThriftStruct& parts(int field, const std::vector<ThriftStruct>& values) {
    list(field, Thrift::kStruct, values.size());
    for (const ThriftStruct& value : values) {
      text_.append(value.ended());
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
constexpr std::int64_t kDouble = 5;
constexpr std::int64_t kByteArray = 6;
constexpr std::int64_t kOptional = 1;
constexpr std::int64_t kUtf8 = 0;
constexpr std::int64_t kTimestampMicros = 10;
constexpr std::int64_t kPlain = 0;
constexpr std::int64_t kRle = 3;

void putPlain(std::string& out, double value) {
  putLittleEndian(out, value);
}
void putPlain(std::string& out, std::int64_t value) {
  putLittleEndian(out, value);
}
void putPlain(std::string& out, const std::string& value) {
  putLittleEndian(out, static_cast<std::uint32_t>(value.size()));
  out.append(value);
}

/// The body of a data page: which rows have a value, in runs, then these values.
template <typename Value>
std::string pageOf(const std::vector<std::optional<Value>>& values) {
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
    putVarint(runs, (next - i) << 1U);
    runs.push_back(values[i] ? '\1' : '\0');
    i = next;
  }
  std::string page;
  putLittleEndian(page, static_cast<std::uint32_t>(runs.size()));
  return page + runs + plain;
}

std::int64_t kindOf(const ParquetValues& values) {
  constexpr std::array kKinds{kDouble, kInt64, kByteArray};
  return kKinds.at(values.index());
}

ThriftStruct schemaOf(const ParquetColumn& column) {
  ThriftStruct element;
  element.whole(1, kindOf(column.values)).whole(3, kOptional).text(4, column.name);
  if (kindOf(column.values) != kDouble) {
    element.whole(6, kindOf(column.values) == kInt64 ? kTimestampMicros : kUtf8);
  }
  return element;
}

std::size_t lengthOf(const ParquetColumn& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
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

void writeParquet(const std::filesystem::path& file, const std::vector<ParquetColumn>& columns,
                  const std::vector<std::pair<std::string, std::string>>& facts) {
  TORSIO_EXPECTS(!columns.empty());
  const std::size_t rows = lengthOf(columns.front());
  std::vector<ThriftStruct> schema(1);
  schema.front().text(4, "schema").whole(5, std::ssize(columns));
  std::vector<ThriftStruct> chunks;
  std::string text(kMagic);
  for (const ParquetColumn& column : columns) {
    TORSIO_EXPECTS(lengthOf(column) == rows);
    const std::string page = std::visit([](const auto& values) { return pageOf(values); }, column.values);
    if (page.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
      throw Error(ErrorCode::kBadData, Text::tr("a column has more than 2 GB: %1", column.name),
                  file.string(), Text::tr("Export fewer lines a second"));
    }
    ThriftStruct values;
    values.whole(1, static_cast<std::int64_t>(rows)).whole(2, kPlain).whole(3, kRle).whole(4, kRle);
    ThriftStruct head;
    head.whole(1, 0).whole(2, std::ssize(page)).whole(3, std::ssize(page)).part(5, values);
    const auto begin = std::ssize(text);
    text += head.ended() + page;
    const std::int64_t bytes = std::ssize(text) - begin;
    ThriftStruct about;
    about.whole(1, kindOf(column.values))
        .wholes(2, {kPlain, kRle})
        .texts(3, {column.name})
        .whole(4, 0)
        .whole(5, static_cast<std::int64_t>(rows), Thrift::kI64)
        .whole(6, bytes, Thrift::kI64)
        .whole(7, bytes, Thrift::kI64)
        .whole(9, begin, Thrift::kI64);
    chunks.emplace_back();
    chunks.back().whole(2, begin, Thrift::kI64).part(3, about);
    schema.push_back(schemaOf(column));
  }
  ThriftStruct group;
  group.parts(1, chunks)
      .whole(2, std::ssize(text) - std::ssize(kMagic), Thrift::kI64)
      .whole(3, static_cast<std::int64_t>(rows), Thrift::kI64);
  ThriftStruct all;
  all.whole(1, 1).parts(2, schema).whole(3, static_cast<std::int64_t>(rows), Thrift::kI64).parts(4, {group});
  if (!facts.empty()) {
    std::vector<ThriftStruct> pairs;
    for (const auto& [key, value] : facts) {
      pairs.emplace_back();
      pairs.back().text(1, key).text(2, value);
    }
    all.parts(5, pairs);
  }
  all.text(6, "torsio");
  const std::string footer = all.ended();
  text += footer;
  putLittleEndian(text, static_cast<std::uint32_t>(footer.size()));
  text += kMagic;
  writeFileAtomically(file, text);
}

}  // namespace torsio
