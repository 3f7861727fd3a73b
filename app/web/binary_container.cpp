// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/binary_container.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>
#include <zlib.h>

#include "sim/core/contracts.h"

namespace torsio::web {

namespace {

static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie in memory");

constexpr std::size_t kAlignment = 4;
constexpr std::size_t kHead = 8;
constexpr int kGzipWindow = 15 + 16;
constexpr int kGzipMemory = 8;

void pad(std::string& bytes, std::size_t before, char with) {
  while ((before + bytes.size()) % kAlignment != 0) {
    bytes.push_back(with);
  }
}

}  // namespace

template <typename Value>
void BinaryContainer::put(const std::string& name, const char* type, std::span<const Value> values) {
  pad(data_, 0, '\0');
  arrays_.push_back({{"name", name}, {"type", type}, {"offset", data_.size()}, {"count", values.size()}});
  data_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

template void BinaryContainer::put(const std::string&, const char*, std::span<const float>);
template void BinaryContainer::put(const std::string&, const char*, std::span<const std::int16_t>);
template void BinaryContainer::put(const std::string&, const char*, std::span<const std::uint32_t>);
template void BinaryContainer::put(const std::string&, const char*, std::span<const std::uint8_t>);

template <typename Value>
void BinaryContainer::putDifferences(const std::string& name, const char* type, std::span<const Value> values,
                                     std::size_t stride) {
  TORSIO_EXPECTS(stride > 0);
  std::vector<Value> differences(values.begin(), values.end());
  for (std::size_t i = stride; i < values.size(); ++i) {
    // Differences that overflow wrap round, and wrap back when summed.
    differences[i] = static_cast<Value>(static_cast<std::uint32_t>(values[i]) -
                                        static_cast<std::uint32_t>(values[i - stride]));
  }
  put(name, type, std::span<const Value>(differences));
  arrays_.back()["delta"] = stride;
}

void BinaryContainer::addDifferences(const std::string& name, std::span<const std::int16_t> values,
                                     std::size_t stride) {
  putDifferences(name, "i16", values, stride);
}

void BinaryContainer::addDifferences(const std::string& name, std::span<const std::uint32_t> values,
                                     std::size_t stride) {
  putDifferences(name, "u32", values, stride);
}

void BinaryContainer::addMultiples(const std::string& name, std::span<const float> values, float step,
                                   std::size_t stride) {
  std::vector<std::int16_t> multiples;
  multiples.reserve(values.size());
  for (const float value : values) {
    const long multiple = std::lround(value / step);
    TORSIO_EXPECTS(multiple >= std::numeric_limits<std::int16_t>::min() &&
                   multiple <= std::numeric_limits<std::int16_t>::max());
    multiples.push_back(static_cast<std::int16_t>(multiple));
  }
  addDifferences(name, std::span<const std::int16_t>(multiples), stride);
  arrays_.back()["scale"] = step;
}

std::string BinaryContainer::bytes() const {
  std::string text = nlohmann::json{{"meta", meta_}, {"arrays", arrays_}}.dump();
  pad(text, kHead, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string all = "TRS1";
  all.append(reinterpret_cast<const char*>(&length), sizeof length);
  return all + text + data_;
}

std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  TORSIO_EXPECTS(deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipWindow, kGzipMemory,
                              Z_DEFAULT_STRATEGY) == Z_OK);
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int result = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  TORSIO_EXPECTS(result == Z_STREAM_END);
  return out;
}

}  // namespace torsio::web
