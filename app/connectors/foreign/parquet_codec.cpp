// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/parquet_codec.h"

#include <algorithm>
#include <array>
#include <utility>
#include <zlib.h>

#include <zstd.h>

namespace torsio {

namespace {

constexpr std::int64_t kAsItIs = 0;
constexpr std::int64_t kSnappy = 1;
constexpr std::int64_t kGzip = 2;
constexpr std::int64_t kZstd = 6;

/// The bytes of a number, lowest first; empty if there are fewer.
std::optional<std::size_t> lowestFirst(std::string_view bytes, std::size_t at, std::size_t count) {
  if (at + count > bytes.size()) {
    return std::nullopt;
  }
  std::size_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + i])) << 8U * i;
  }
  return value;
}

/// https://github.com/google/snappy/blob/main/format_description.txt
bool unpackSnappy(std::string_view packed, std::string& out) {
  std::size_t at = 0;
  std::uint64_t stated = 0;
  for (unsigned shift = 0;; shift += 7) {
    if (at == packed.size() || shift > 28) {
      return false;
    }
    const auto next = static_cast<unsigned char>(packed[at++]);
    stated |= static_cast<std::uint64_t>(next & 0x7FU) << shift;
    if (next < 0x80U) {
      break;
    }
  }
  if (stated != out.size()) {
    return false;
  }
  std::size_t made = 0;
  while (at < packed.size()) {
    const auto tag = static_cast<unsigned char>(packed[at++]);
    const unsigned kind = tag & 3U;
    std::size_t length = tag >> 2U;
    if (kind == 0) {  // bytes as they are
      constexpr std::size_t kInTag = 60;
      if (length >= kInTag) {
        const std::size_t bytes = length - kInTag + 1;
        const auto stretched = lowestFirst(packed, at, bytes);
        if (!stretched) {
          return false;
        }
        length = *stretched;
        at += bytes;
      }
      ++length;
      if (length > packed.size() - at || length > out.size() - made) {
        return false;
      }
      std::copy_n(packed.begin() + static_cast<std::ptrdiff_t>(at), length,
                  out.begin() + static_cast<std::ptrdiff_t>(made));
      at += length;
      made += length;
      continue;
    }
    const std::size_t bytes = kind == 3 ? 4 : kind;
    const auto back = lowestFirst(packed, at, bytes);
    if (!back) {
      return false;
    }
    at += bytes;
    const std::size_t offset = kind == 1 ? *back | static_cast<std::size_t>(tag >> 5U) << 8U : *back;
    length = kind == 1 ? 4 + (length & 7U) : length + 1;
    if (offset == 0 || offset > made || length > out.size() - made) {
      return false;
    }
    for (std::size_t i = 0; i < length; ++i, ++made) {  // may run into what it writes
      out[made] = out[made - offset];
    }
  }
  return made == out.size();
}

bool unpackGzip(std::string_view packed, std::string& out) {
  constexpr int kGzipOrZlib = 32;
  z_stream stream{};
  if (inflateInit2(&stream, MAX_WBITS + kGzipOrZlib) != Z_OK) {
    return false;
  }
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib reads only
  stream.avail_in = static_cast<uInt>(packed.size());
  char none = 0;
  stream.next_out = reinterpret_cast<Bytef*>(out.empty() ? &none : out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int ended = inflate(&stream, Z_FINISH);
  const bool whole = ended == Z_STREAM_END && stream.avail_out == 0;
  inflateEnd(&stream);
  return whole;
}

}  // namespace

bool isReadCodec(std::int64_t codec) noexcept {
  return codec == kAsItIs || codec == kSnappy || codec == kGzip || codec == kZstd;
}

std::string codecName(std::int64_t codec) {
  constexpr std::array kNames = {"nothing", "Snappy", "gzip", "LZO", "Brotli", "LZ4", "zstd", "LZ4_RAW"};
  const bool known = codec >= 0 && codec < std::ssize(kNames);
  return known ? kNames[static_cast<std::size_t>(codec)] : std::to_string(codec);
}

std::optional<std::string> unpackedPage(std::int64_t codec, std::string_view packed, std::size_t size) {
  if (codec == kAsItIs) {
    return packed.size() == size ? std::optional(std::string(packed)) : std::nullopt;
  }
  std::string out(size, '\0');
  bool whole = false;
  if (codec == kSnappy) {
    whole = unpackSnappy(packed, out);
  } else if (codec == kGzip) {
    whole = unpackGzip(packed, out);
  } else {
    whole = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size()) == size;
  }
  return whole ? std::optional(std::move(out)) : std::nullopt;
}

std::uint32_t pageChecksum(std::string_view page) noexcept {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(page.data()), static_cast<uInt>(page.size())));
}

}  // namespace torsio
