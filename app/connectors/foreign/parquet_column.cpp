// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/parquet_column.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/connectors/foreign/parquet_codec.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::size_t kMaxHeadBytes = 64U << 10U;  // limits: what a damaged file may make this program hold
constexpr std::size_t kMaxPageBytes = 32U << 20U;
constexpr std::size_t kMaxUnpackedBytes = 16U << 20U;
constexpr std::size_t kMaxDictionaryBytes = 4U << 20U;

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

std::string ParquetColumnReader::next() {
  try {
    return valueOf();
  } catch (const PageDamaged&) {
    refuseDamagedParquet(file_->placeOf(leaf_));
  } catch (const ThriftReader::Damaged&) {
    refuseDamagedParquet(file_->placeOf(leaf_));
  }
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
  if (chunk.kind != static_cast<std::int64_t>(leaf_.kind) || chunk.values != rows || begin < 0 ||
      begin > room) {
    refuseDamagedParquet(file_->placeOf(leaf_));
  }
  at_ = static_cast<std::size_t>(begin);
  valuesLeft_ = rows;
  codec_ = chunk.codec;
  inPage_ = 0;
  dictionary_.clear();
}

std::string ParquetColumnReader::valueOf() {
  while (inPage_ == 0) {
    nextPage();
  }
  --inPage_;
  if (leaf_.optional && given_.next() == 0) {
    return {};
  }
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
    if (head.repetitionBytes != 0 || head.levelBytes < 0 ||
        static_cast<std::size_t>(head.levelBytes) > std::min(packed, unpacked)) {
      throw PageDamaged();
    }
    levels = static_cast<std::size_t>(head.levelBytes);
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
  if (head.kind == kDataPage2) {
    given_ = LevelReader(bytes.substr(0, levels), 1);
    bytes.remove_prefix(levels);
  } else if (leaf_.optional) {
    if (head.levelEncoding != kRunsAndBits) {
      refuseEncoding(head.levelEncoding);
    }
    given_ = LevelReader(sized(bytes), 1);
  }
  numbers_.reset();
  if (head.encoding == kPlainValues) {
    plain_ = PageValues(leaf_, bytes);
  } else if (head.encoding == kPlainDictionary || head.encoding == kRleDictionary) {
    constexpr unsigned kMostBits = 32;
    const unsigned bits = bytes.empty() ? 0 : static_cast<unsigned char>(bytes.front());
    if (bits > kMostBits) {
      throw PageDamaged();
    }
    numbers_.emplace(bytes.substr(bytes.empty() ? 0 : 1), bits);
  } else if (head.encoding == kRunsAndBits && leaf_.kind == ParquetKind::kBoolean) {
    numbers_.emplace(sized(bytes), 1);
  } else {
    refuseEncoding(head.encoding);
  }
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
