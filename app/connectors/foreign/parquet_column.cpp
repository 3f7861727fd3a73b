// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/parquet_column.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "app/connectors/foreign/parquet_codec.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::size_t kMaxHeadBytes = 64U << 10U;  // limits: what a damaged file may make this program hold
constexpr std::size_t kMaxPageBytes = 32U << 20U;
constexpr std::size_t kMaxUnpackedBytes = 16U << 20U;
constexpr std::size_t kMaxDictionaryBytes = 4U << 20U;
constexpr std::size_t kMaxItems = 10'000;  // of a row's list

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

/// Takes bytes that are preceded by their length from the front.
std::string_view sized(std::string_view& bytes) {
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

}  // namespace

void refuseDamagedParquet(const std::string& where) {
  refuse(Text::tr("the Parquet file is damaged or incomplete"), where, Text::tr("Copy or write it again"));
}

ParquetBytes::ParquetBytes(const std::filesystem::path& file, std::string name)
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
  dataEnd_ = size_;
}

std::string ParquetBytes::bytesAt(std::size_t at, std::size_t count) {
  std::string bytes(count, '\0');
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(at));
  in_.read(bytes.data(), static_cast<std::streamsize>(count));
  if (static_cast<std::size_t>(in_.gcount()) != count) {
    refuseDamagedParquet(name_);
  }
  return bytes;
}

void ParquetColumnReader::next() {
  try {
    readRow();
  } catch (const PageDamaged&) {
    refuseDamagedParquet(file_->placeOf(leaf_));
  } catch (const ThriftReader::Damaged&) {
    refuseDamagedParquet(file_->placeOf(leaf_));
  }
}

const std::string& ParquetColumnReader::item(std::size_t index) const {
  static const std::string kNone;
  if (row_.empty()) {
    return kNone;
  }
  if (index >= row_.size()) {
    refuseHere(Text::tr("a list has %1 {value|values}, so there is no [%2]", row_.size(), index),
               Text::tr("Items are counted from 0; correct the map"));
  }
  return row_[index];
}

void ParquetColumnReader::begin(const ParquetChunk& chunk, std::int64_t rows) {
  if (chunk.elsewhere) {
    refuseHere(Text::tr("the values are encrypted or in another file"),
               Text::tr("Write one file without encryption"));
  }
  if (!isReadCodec(chunk.codec)) {
    refuseHere(Text::tr("the values are packed with %1, which is not read", codecName(chunk.codec)),
               Text::tr("Write the file unpacked, or packed with Snappy, gzip or zstd"));
  }
  const bool dictionary = chunk.dictionaryAt > 0 && chunk.dictionaryAt < chunk.dataAt;
  const std::int64_t begin = dictionary ? chunk.dictionaryAt : chunk.dataAt;
  const auto room = static_cast<std::int64_t>(file_->dataEnd());
  if (chunk.kind != static_cast<std::int64_t>(leaf_.kind) || begin < 0 || begin > room ||
      (isList() ? chunk.values < rows : chunk.values != rows)) {
    refuseDamagedParquet(file_->placeOf(leaf_));
  }
  at_ = static_cast<std::size_t>(begin);
  valuesLeft_ = chunk.values;
  ahead_.reset();
  codec_ = chunk.codec;
  inPage_ = 0;
  dictionary_.clear();
}

void ParquetColumnReader::readRow() {
  row_.clear();
  if (!isList()) {
    while (inPage_ == 0) {
      nextPage();
    }
    readEntry();
    return;
  }
  if (goesOn() || !ahead_) {
    throw PageDamaged();  // the list of a row that ended, or no row at all
  }
  do {
    ahead_.reset();
    if (row_.size() == kMaxItems) {
      refuseHere(Text::tr("a list has more than %1 values", kMaxItems), Text::tr("Name another column"));
    }
    readEntry();
  } while (goesOn());
}

bool ParquetColumnReader::goesOn() {
  if (!ahead_) {
    if (inPage_ == 0 && valuesLeft_ == 0) {
      return false;
    }
    while (inPage_ == 0) {
      nextPage();
    }
    ahead_ = repeats_.next();
  }
  return *ahead_ > 0;
}

void ParquetColumnReader::readEntry() {
  --inPage_;
  const std::uint32_t level = leaf_.given == 0 ? 0 : given_.next();
  if (level == leaf_.given) {
    row_.push_back(valueOf());
  } else if (isList() && leaf_.mayLackItem && level + 1 == leaf_.given) {
    row_.emplace_back();
  }
}

std::string ParquetColumnReader::valueOf() {
  if (!numbers_) {
    return plain_.next();
  }
  const std::uint32_t number = numbers_->next();
  if (leaf_.kind == ParquetKind::kBoolean) {
    return number != 0 ? "1" : "0";
  }
  if (number >= dictionary_.size()) {
    throw PageDamaged();
  }
  return dictionary_[number];
}

void ParquetColumnReader::nextPage() {
  if (at_ >= file_->dataEnd()) {
    throw PageDamaged();
  }
  const std::size_t left = file_->dataEnd() - at_;
  const ParquetPage head = pageHead(file_->bytesAt(at_, std::min(left, kMaxHeadBytes)));
  if (head.packed < 0 || head.unpacked < 0 || head.values < 0 ||
      static_cast<std::size_t>(head.packed) > left - head.bytes) {
    throw PageDamaged();
  }
  const auto packed = static_cast<std::size_t>(head.packed);
  const auto unpacked = static_cast<std::size_t>(head.unpacked);
  const bool isPacked = codec_ != 0 && (head.kind != kDataPage2 || head.isPacked);
  const std::size_t most = head.kind == kDictionaryPage ? kMaxDictionaryBytes
                           : isPacked                   ? kMaxUnpackedBytes
                                                        : kMaxPageBytes;
  if (std::max(packed, unpacked) > most) {
    refuseHere(Text::tr("a page has more than %1 MiB", most >> 20U),
               Text::tr("Write the file with pages of the usual size, 1 MiB"));
  }
  const std::size_t at = at_ + head.bytes;
  at_ = at + packed;
  if (head.kind != kDataPage && head.kind != kDataPage2 && head.kind != kDictionaryPage) {
    return;
  }
  std::string bytes = file_->bytesAt(at, packed);
  if (head.checksum && static_cast<std::uint32_t>(*head.checksum) != pageChecksum(bytes)) {
    refuseHere(Text::tr("the checksum of a page is wrong"), Text::tr("Copy or write it again"));
  }
  std::size_t levels = 0;  // of version 2, which never packs them
  if (head.kind == kDataPage2) {
    const auto room = static_cast<std::int64_t>(std::min(packed, unpacked));
    if (head.repetitionBytes < 0 || head.levelBytes < 0 || head.repetitionBytes > room ||
        head.levelBytes > room - head.repetitionBytes || (!isList() && head.repetitionBytes != 0)) {
      throw PageDamaged();
    }
    levels = static_cast<std::size_t>(head.repetitionBytes + head.levelBytes);
  }
  if (isPacked) {
    std::optional<std::string> values =
        unpackedPage(codec_, std::string_view(bytes).substr(levels), unpacked - levels);
    if (!values) {
      throw PageDamaged();
    }
    bytes = bytes.substr(0, levels) + *values;
  } else if (packed != unpacked) {
    throw PageDamaged();
  }
  if (head.kind == kDictionaryPage) {
    takeDictionary(head, bytes);
    return;
  }
  if (head.values > valuesLeft_) {
    throw PageDamaged();
  }
  valuesLeft_ -= head.values;
  inPage_ = head.values;
  page_ = std::move(bytes);
  beginValues(head, levels);
}

void ParquetColumnReader::takeDictionary(const ParquetPage& head, const std::string& bytes) {
  if (head.encoding != kPlainValues && head.encoding != kPlainDictionary) {
    refuseEncoding(head.encoding);
  }
  if (!dictionary_.empty() || static_cast<std::size_t>(head.values) > bytes.size()) {
    throw PageDamaged();
  }
  PageValues values(leaf_, bytes);
  for (std::int64_t i = 0; i < head.values; ++i) {
    dictionary_.push_back(values.next());
  }
}

void ParquetColumnReader::beginValues(const ParquetPage& head, std::size_t levels) {
  std::string_view bytes = page_;
  const auto bits = static_cast<unsigned>(std::bit_width(leaf_.given));
  if (head.kind == kDataPage2) {
    const auto repeats = static_cast<std::size_t>(head.repetitionBytes);
    repeats_ = LevelReader(bytes.substr(0, repeats), 1);
    given_ = LevelReader(bytes.substr(repeats, levels - repeats), bits);
    bytes.remove_prefix(levels);
  } else {
    if (isList()) {
      repeats_ = LevelReader(levelsOf(head.repetitionEncoding, bytes), 1);
    }
    if (leaf_.given > 0) {
      given_ = LevelReader(levelsOf(head.levelEncoding, bytes), bits);
    }
  }
  numbers_.reset();
  if (head.encoding == kPlainValues) {
    plain_ = PageValues(leaf_, bytes);
  } else if (head.encoding == kPlainDictionary || head.encoding == kRleDictionary) {
    constexpr unsigned kMaxBits = 32;
    const unsigned width = bytes.empty() ? 0 : static_cast<unsigned char>(bytes.front());
    if (width > kMaxBits) {
      throw PageDamaged();
    }
    numbers_.emplace(bytes.substr(bytes.empty() ? 0 : 1), width);
  } else if (head.encoding == kRunsAndBits && leaf_.kind == ParquetKind::kBoolean) {
    numbers_.emplace(sized(bytes), 1);
  } else {
    refuseEncoding(head.encoding);
  }
}

std::string_view ParquetColumnReader::levelsOf(std::int64_t encoding, std::string_view& bytes) const {
  if (encoding != kRunsAndBits) {
    refuseEncoding(encoding);
  }
  return sized(bytes);
}

void ParquetColumnReader::refuseEncoding(std::int64_t encoding) const {
  const bool known = encoding >= 0 && encoding < std::ssize(kEncodingNames);
  refuseHere(Text::tr("the values are encoded as %1, which is not read",
                      known ? kEncodingNames[static_cast<std::size_t>(encoding)] : std::to_string(encoding)),
             Text::tr("Write them with plain or dictionary encoding"));
}

void ParquetColumnReader::refuseHere(const Text& what, const Text& remedy) const {
  refuse(what, file_->placeOf(leaf_), remedy);
}

}  // namespace torsio
