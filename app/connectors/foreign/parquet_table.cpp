// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://parquet.apache.org/docs/file-format. Numbers of fields and kinds below are those of its
// parquet.thrift.
#include "app/connectors/foreign/parquet_table.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

#include "app/connectors/foreign/parquet_codec.h"
#include "app/connectors/foreign/parquet_meta.h"
#include "app/connectors/foreign/parquet_page.h"
#include "app/connectors/foreign/parquet_thrift.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::string_view kParquetMark = "PAR1";
constexpr std::string_view kEncryptedMark = "PARE";
constexpr std::size_t kFooterEnd = 8;                // its length and the mark
constexpr std::size_t kMaxFooterBytes = 16U << 20U;  // limits: what a damaged file may make this program hold
constexpr std::size_t kMaxHeadBytes = 64U << 10U;
constexpr std::size_t kMaxPageBytes = 32U << 20U;
constexpr std::size_t kMaxUnpackedBytes = 16U << 20U;
constexpr std::size_t kMaxDictionaryBytes = 4U << 20U;
constexpr std::int64_t kMaxRows = 50'000'000;

constexpr std::int64_t kDataPage = 0;
constexpr std::int64_t kDictionaryPage = 2;
constexpr std::int64_t kDataPage2 = 3;

constexpr std::int64_t kPlainValues = 0;
constexpr std::int64_t kPlainDictionary = 2;
constexpr std::int64_t kRunsAndBits = 3;
constexpr std::int64_t kRleDictionary = 8;
constexpr std::array kEncodingNames = {
    "PLAIN",          "GROUP_VAR_INT",       "PLAIN_DICTIONARY",        "RLE",
    "BIT_PACKED",     "DELTA_BINARY_PACKED", "DELTA_LENGTH_BYTE_ARRAY", "DELTA_BYTE_ARRAY",
    "RLE_DICTIONARY", "BYTE_STREAM_SPLIT"};

}  // namespace

bool isParquet(const std::filesystem::path& file) {
  std::array<char, kParquetMark.size()> head{};
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), head.size());
  return in && std::string_view(head.data(), head.size()) == kParquetMark;
}

class ParquetTable::Reader {
 public:
  Reader(const std::filesystem::path& file, std::string name, const std::vector<std::string>& columns)
      : name_(std::move(name)), in_(file, std::ios::binary) {
    if (!std::filesystem::is_regular_file(file)) {
      throw Error(ErrorCode::kFileMissing, Text::tr("there is no such file"), file.string(),
                  Text::tr("Check the names in the map"));
    }
    if (!in_) {
      throw Error(ErrorCode::kFileUnreadable, Text::tr("the file cannot be read"), file.string(),
                  Text::tr("Check its permissions"));
    }
    size_ = std::filesystem::file_size(file);
    readFooter();
    for (const std::string& column : columns) {
      choose(column);
    }
  }

  bool next(std::vector<std::string>& cells) {
    while (rowsLeft_ == 0) {
      if (groupsLeft_ == 0) {
        return false;
      }
      nextGroup();
    }
    --rowsLeft_;
    cells.resize(columns_.size());
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      try {
        cells[c] = valueOf(columns_[c]);
      } catch (const PageDamaged&) {
        refuseDamaged(columns_[c]);
      } catch (const ThriftReader::Damaged&) {
        refuseDamaged(columns_[c]);
      }
    }
    return true;
  }
  [[nodiscard]] std::string timeUnit(std::size_t column) const {
    return leaves_[columns_[column].leaf].timeUnit;
  }

 private:
  /// A column that is read: where it is in the current row group, and what is left of the current page.
  struct Column {
    std::size_t leaf = 0;
    ParquetChunk chunk{};
    std::size_t at = 0;           ///< of the next page in the file
    std::int64_t valuesLeft = 0;  ///< in pages to come
    std::int64_t inPage = 0;
    std::string dictionaryPage{};
    std::vector<std::string> dictionary{};
    std::string page{};
    LevelReader given{};                   ///< whether there is a value
    std::optional<LevelReader> numbers{};  ///< in the dictionary, or truth values; empty: PLAIN
    PageValues plain{};
  };

  [[noreturn]] void refuseFile(const Text& what, const Text& remedy) const { refuse(what, name_, remedy); }
  [[noreturn]] void refuseDamagedFile() const {
    refuseFile(Text::tr("the Parquet file is damaged or incomplete"), Text::tr("Copy or write it again"));
  }
  [[noreturn]] void refuseColumn(const Column& column, const Text& what, const Text& remedy) const {
    refuse(what, placeOf(leaves_[column.leaf]), remedy);
  }
  [[noreturn]] void refuseDamaged(const Column& column) const {
    refuseColumn(column, Text::tr("the Parquet file is damaged or incomplete"),
                 Text::tr("Copy or write it again"));
  }
  [[nodiscard]] std::string placeOf(const ParquetLeaf& leaf) const { return name_ + ", " + leaf.name; }

  [[nodiscard]] std::string bytesAt(std::size_t at, std::size_t count) {
    std::string bytes(count, '\0');
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(at));
    in_.read(bytes.data(), static_cast<std::streamsize>(count));
    if (static_cast<std::size_t>(in_.gcount()) != count) {
      refuseDamagedFile();
    }
    return bytes;
  }

  void readFooter() {
    const std::size_t least = kParquetMark.size() + kFooterEnd;
    const std::string end =
        size_ < least ? std::string(kFooterEnd, '\0') : bytesAt(size_ - kFooterEnd, kFooterEnd);
    const std::string mark = end.substr(kFooterEnd - kParquetMark.size());
    if (mark == kEncryptedMark) {
      refuseFile(Text::tr("the Parquet file is encrypted"), Text::tr("Write it without encryption"));
    }
    if (mark != kParquetMark || bytesAt(0, kParquetMark.size()) != kParquetMark) {
      refuseFile(Text::tr("this is not a complete Parquet file"),
                 Text::tr("Choose a Parquet file, or name the form that this file has"));
    }
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length |= static_cast<std::size_t>(static_cast<unsigned char>(end[i])) << 8U * i;
    }
    if (length > size_ - least || length > kMaxFooterBytes) {
      refuseDamagedFile();
    }
    dataEnd_ = size_ - kFooterEnd - length;
    footer_ = bytesAt(dataEnd_, length);
    try {
      hearFooter();
    } catch (const ThriftReader::Damaged&) {
      refuseDamagedFile();
    }
    if (rows_ < 0 || rows_ > kMaxRows) {
      refuseFile(Text::tr("the file has %1 {row|rows}, more than 50 million", rows_),
                 Text::tr("Split it into a file for each recording"));
    }
  }

  void hearFooter() {
    ThriftReader in(footer_);
    in.fields([&](int field, unsigned) {
      switch (field) {
        case 2:
          leaves_ = leavesOf(in);
          return true;
        case 3:
          rows_ = in.whole();
          return true;
        case 4: {
          groupsAt_ = in.at();
          in.skip(ThriftReader::kList);
          return true;
        }
        default:
          return false;
      }
    });
    if (groupsAt_ > 0) {
      groups_.emplace(std::string_view(footer_).substr(groupsAt_));
      groupsLeft_ = groups_->list().size;
    }
  }

  void choose(const std::string& wanted) {
    const auto isIt = [&](const ParquetLeaf& leaf) { return leaf.name == wanted; };
    const auto found = std::find_if(leaves_.begin(), leaves_.end(), isIt);
    if (found == leaves_.end()) {
      std::string known;
      constexpr std::size_t kMostNames = 300;  // letters
      for (const ParquetLeaf& leaf : leaves_) {
        if (known.size() > kMostNames) {
          known += ", …";
          break;
        }
        known += (known.empty() ? "" : ", ") + leaf.name;
      }
      refuseFile(Text::tr("there must be exactly one column '%1'", wanted),
                 Text::tr("Use one of its columns: %1", known));
    }
    if (!found->flat) {
      refuse(Text::tr("the column has lists or groups of values"), placeOf(*found),
             Text::tr("Write each of its numbers as a column of its own"));
    }
    if (std::count_if(leaves_.begin(), leaves_.end(), isIt) > 1) {
      refuseFile(Text::tr("there must be exactly one column '%1'", wanted), Text::tr("Rename the others"));
    }
    const bool number = found->kind == ParquetKind::kInt32 || found->kind == ParquetKind::kInt64 ||
                        found->kind == ParquetKind::kFloat || found->kind == ParquetKind::kDouble ||
                        found->kind == ParquetKind::kBoolean;
    constexpr std::int64_t kMaxScale = 18;
    if (!number && !(found->kind == ParquetKind::kBytes && found->isText)) {
      refuse(Text::tr("the column is stored in a way that is not read (%1)",
                      found->isHalf                             ? "FLOAT16"
                      : found->kind == ParquetKind::kInt96      ? "INT96"
                      : found->kind == ParquetKind::kFixedBytes ? "FIXED_LEN_BYTE_ARRAY"
                                                                : "BYTE_ARRAY"),
             placeOf(*found),
             Text::tr("Write it as whole numbers, as decimal numbers of 32 or 64 bits, or as text"));
    }
    if (found->scale < 0 || found->scale > kMaxScale) {
      refuseDamagedFile();
    }
    columns_.emplace_back();
    columns_.back().leaf = static_cast<std::size_t>(found - leaves_.begin());
  }

  void nextGroup() {
    --groupsLeft_;
    for (Column& column : columns_) {
      column.chunk = ParquetChunk();
    }
    std::int64_t rows = -1;
    std::size_t chunks = 0;
    try {
      groups_->fields([&](int field, unsigned) {
        if (field == 3) {
          rows = groups_->whole();
          return true;
        }
        if (field != 1) {
          return false;
        }
        chunks = groups_->list().size;
        for (std::size_t i = 0; i < chunks; ++i) {
          const ParquetChunk chunk = chunkOf(*groups_);
          for (Column& column : columns_) {
            if (column.leaf == i) {
              column.chunk = chunk;
            }
          }
        }
        return true;
      });
    } catch (const ThriftReader::Damaged&) {
      refuseDamagedFile();
    }
    if (chunks != leaves_.size() || rows < 0 || rows > rows_ - rowsSeen_) {
      refuseDamagedFile();
    }
    rowsSeen_ += rows;
    rowsLeft_ = rows;
    for (Column& column : columns_) {
      beginChunk(column, rows);
    }
    if (groupsLeft_ == 0 && rowsSeen_ != rows_) {
      refuseDamagedFile();
    }
  }

  void beginChunk(Column& column, std::int64_t rows) {
    const ParquetChunk& chunk = column.chunk;
    if (chunk.elsewhere) {
      refuseColumn(column, Text::tr("the values are encrypted or in another file"),
                   Text::tr("Write one file without encryption"));
    }
    if (!isReadCodec(chunk.codec)) {
      refuseColumn(column,
                   Text::tr("the values are packed with %1, which is not read", codecName(chunk.codec)),
                   Text::tr("Write the file unpacked, or packed with Snappy, gzip or zstd"));
    }
    const bool dictionary = chunk.dictionaryAt > 0 && chunk.dictionaryAt < chunk.dataAt;
    const std::int64_t begin = dictionary ? chunk.dictionaryAt : chunk.dataAt;
    const auto room = static_cast<std::int64_t>(dataEnd_);
    if (chunk.kind != static_cast<std::int64_t>(leaves_[column.leaf].kind) || chunk.values != rows ||
        begin < 0 || begin > room) {
      refuseDamaged(column);
    }
    column.at = static_cast<std::size_t>(begin);
    column.valuesLeft = rows;
    column.inPage = 0;
    column.dictionary.clear();
  }

  [[nodiscard]] std::string valueOf(Column& column) {
    while (column.inPage == 0) {
      nextPage(column);
    }
    --column.inPage;
    const ParquetLeaf& leaf = leaves_[column.leaf];
    if (leaf.optional && column.given.next() == 0) {
      return {};
    }
    if (!column.numbers) {
      return column.plain.next();
    }
    const std::uint32_t number = column.numbers->next();
    if (leaf.kind == ParquetKind::kBoolean) {
      return number != 0 ? "1" : "0";
    }
    if (number >= column.dictionary.size()) {
      throw PageDamaged();
    }
    return column.dictionary[number];
  }

  /// Reads a page into `column`; a page without values (a dictionary, an index) leaves none.
  void nextPage(Column& column) {
    if (column.at >= dataEnd_) {
      throw PageDamaged();
    }
    const std::size_t left = dataEnd_ - column.at;
    const ParquetPage head = pageHead(bytesAt(column.at, std::min(left, kMaxHeadBytes)));
    if (head.packed < 0 || head.unpacked < 0 || head.values < 0 ||
        static_cast<std::size_t>(head.packed) > left - head.bytes) {
      throw PageDamaged();
    }
    const auto packed = static_cast<std::size_t>(head.packed);
    const auto unpacked = static_cast<std::size_t>(head.unpacked);
    const bool isPacked = column.chunk.codec != 0 && (head.kind != kDataPage2 || head.isPacked);
    const std::size_t most = head.kind == kDictionaryPage ? kMaxDictionaryBytes
                             : isPacked                   ? kMaxUnpackedBytes
                                                          : kMaxPageBytes;
    if (std::max(packed, unpacked) > most) {
      refuseColumn(column, Text::tr("a page has more than %1 MiB", most >> 20U),
                   Text::tr("Write the file with pages of the usual size, 1 MiB"));
    }
    const std::size_t at = column.at + head.bytes;
    column.at = at + packed;
    if (head.kind != kDataPage && head.kind != kDataPage2 && head.kind != kDictionaryPage) {
      return;
    }
    std::string bytes = bytesAt(at, packed);
    if (head.checksum && static_cast<std::uint32_t>(*head.checksum) != pageChecksum(bytes)) {
      refuseColumn(column, Text::tr("the checksum of a page is wrong"), Text::tr("Copy or write it again"));
    }
    std::size_t levels = 0;  // of version 2, which never packs them
    if (head.kind == kDataPage2) {
      if (head.repetitionBytes != 0 || head.levelBytes < 0 ||
          static_cast<std::size_t>(head.levelBytes) > std::min(packed, unpacked)) {
        throw PageDamaged();
      }
      levels = static_cast<std::size_t>(head.levelBytes);
    }
    if (isPacked) {
      std::optional<std::string> values =
          unpackedPage(column.chunk.codec, std::string_view(bytes).substr(levels), unpacked - levels);
      if (!values) {
        throw PageDamaged();
      }
      bytes = bytes.substr(0, levels) + *values;
    } else if (packed != unpacked) {
      throw PageDamaged();
    }
    if (head.kind == kDictionaryPage) {
      takeDictionary(column, head, bytes);
      return;
    }
    if (head.values > column.valuesLeft) {
      throw PageDamaged();
    }
    column.valuesLeft -= head.values;
    column.inPage = head.values;
    column.page = std::move(bytes);
    beginValues(column, head, levels);
  }

  void takeDictionary(Column& column, const ParquetPage& head, const std::string& bytes) {
    if (head.encoding != kPlainValues && head.encoding != kPlainDictionary) {
      refuseEncoding(column, head.encoding);
    }
    if (!column.dictionary.empty() || static_cast<std::size_t>(head.values) > bytes.size()) {
      throw PageDamaged();
    }
    PageValues values(leaves_[column.leaf], bytes);
    for (std::int64_t i = 0; i < head.values; ++i) {
      column.dictionary.push_back(values.next());
    }
  }

  void beginValues(Column& column, const ParquetPage& head, std::size_t levels) {
    const ParquetLeaf& leaf = leaves_[column.leaf];
    std::string_view bytes = column.page;
    if (head.kind == kDataPage2) {
      column.given = LevelReader(bytes.substr(0, levels), 1);
      bytes.remove_prefix(levels);
    } else if (leaf.optional) {
      if (head.levelEncoding != kRunsAndBits) {
        refuseEncoding(column, head.levelEncoding);
      }
      column.given = LevelReader(sized(bytes), 1);
    }
    column.numbers.reset();
    if (head.encoding == kPlainValues) {
      column.plain = PageValues(leaf, bytes);
    } else if (head.encoding == kPlainDictionary || head.encoding == kRleDictionary) {
      constexpr unsigned kMostBits = 32;
      const unsigned bits = bytes.empty() ? 0 : static_cast<unsigned char>(bytes.front());
      if (bits > kMostBits) {
        throw PageDamaged();
      }
      column.numbers.emplace(bytes.substr(bytes.empty() ? 0 : 1), bits);
    } else if (head.encoding == kRunsAndBits && leaf.kind == ParquetKind::kBoolean) {
      column.numbers.emplace(sized(bytes), 1);
    } else {
      refuseEncoding(column, head.encoding);
    }
  }

  /// Takes bytes that are preceded by their length from the front.
  static std::string_view sized(std::string_view& bytes) {
    constexpr std::size_t kLength = 4;
    std::size_t length = 0;
    for (std::size_t i = 0; i < kLength && bytes.size() >= kLength; ++i) {
      length |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])) << 8U * i;
    }
    if (bytes.size() < kLength || length > bytes.size() - kLength) {
      throw PageDamaged();
    }
    const std::string_view taken = bytes.substr(kLength, length);
    bytes.remove_prefix(kLength + length);
    return taken;
  }

  [[noreturn]] void refuseEncoding(const Column& column, std::int64_t encoding) const {
    const bool known = encoding >= 0 && encoding < std::ssize(kEncodingNames);
    refuseColumn(
        column,
        Text::tr("the values are encoded as %1, which is not read",
                 known ? kEncodingNames[static_cast<std::size_t>(encoding)] : std::to_string(encoding)),
        Text::tr("Write them with plain or dictionary encoding"));
  }

  std::string name_;
  std::ifstream in_;
  std::size_t size_ = 0;
  std::size_t dataEnd_ = 0;
  std::string footer_;
  std::vector<ParquetLeaf> leaves_;
  std::vector<Column> columns_;
  std::int64_t rows_ = 0;
  std::int64_t rowsSeen_ = 0;  ///< in row groups up to the current one
  std::int64_t rowsLeft_ = 0;  ///< in the current one
  std::size_t groupsAt_ = 0;
  std::size_t groupsLeft_ = 0;
  std::optional<ThriftReader> groups_;
};

ParquetTable::ParquetTable(const std::filesystem::path& file, std::string name,
                           const std::vector<std::string>& columns)
    : reader_(std::make_unique<Reader>(file, std::move(name), columns)) {}
ParquetTable::~ParquetTable() = default;

bool ParquetTable::next(std::vector<std::string>& cells) {
  return reader_->next(cells);
}

std::string ParquetTable::timeUnit(std::size_t column) const {
  return reader_->timeUnit(column);
}

}  // namespace torsio
