// SPDX-License-Identifier: GPL-3.0-or-later
// The encodings: https://parquet.apache.org/docs/file-format/data-pages/encodings.
#include "app/connectors/foreign/parquet_page.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace torsio {

namespace {

constexpr std::size_t kByteBits = 8;

template <typename Number>
std::string digitsOf(Number value) {
  std::array<char, 40> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::string(text.data(), end) : std::string();
}

std::string decimalOf(std::int64_t value, std::int64_t scale) {
  return digitsOf(static_cast<double>(value) / std::pow(10.0, static_cast<double>(scale)));
}

template <typename Real>
std::string realOf(Real value) {
  return std::isnan(value) ? "nan" : digitsOf(value);
}

}  // namespace

void LevelReader::begin() {
  std::uint64_t head = 0;
  for (unsigned shift = 0;; shift += 7) {
    if (at_ == bytes_.size() || shift > 63) {
      throw PageDamaged();
    }
    const auto next = static_cast<unsigned char>(bytes_[at_++]);
    head |= static_cast<std::uint64_t>(next & 0x7FU) << shift;
    if (next < 0x80U) {
      break;
    }
  }
  if ((head & 1U) != 0) {
    const std::uint64_t groups = head >> 1U;  // of eight numbers
    if (bits_ > 0 && groups > (bytes_.size() - at_) / bits_) {
      throw PageDamaged();
    }
    packed_ = groups * kByteBits;
    bitAt_ = 0;
    return;
  }
  repeats_ = head >> 1U;
  const std::size_t size = (bits_ + kByteBits - 1) / kByteBits;
  if (size > bytes_.size() - at_) {
    throw PageDamaged();
  }
  value_ = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value_ |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[at_++])) << kByteBits * i;
  }
}

std::uint32_t LevelReader::next() {
  while (repeats_ == 0 && packed_ == 0) {
    begin();
  }
  if (repeats_ > 0) {
    --repeats_;
    return value_;
  }
  std::uint32_t value = 0;
  for (unsigned i = 0; i < bits_; ++i, ++bitAt_) {
    const auto byte = static_cast<unsigned char>(bytes_[at_ + bitAt_ / kByteBits]);
    value |= static_cast<std::uint32_t>(byte >> bitAt_ % kByteBits & 1U) << i;
  }
  if (--packed_ == 0) {
    at_ += bitAt_ / kByteBits;
  }
  return value;
}

template <typename Number>
Number PageValues::number() {
  if (sizeof(Number) > bytes_.size() - at_) {
    throw PageDamaged();
  }
  Number value{};
  std::memcpy(&value, bytes_.data() + at_, sizeof(Number));
  at_ += sizeof(Number);
  return value;
}

std::string PageValues::next() {
  switch (leaf_->kind) {
    case ParquetKind::kBoolean: {
      if (bit_ / kByteBits >= bytes_.size()) {
        throw PageDamaged();
      }
      const auto byte = static_cast<unsigned char>(bytes_[bit_ / kByteBits]);
      return (byte >> bit_++ % kByteBits & 1U) != 0 ? "1" : "0";
    }
    case ParquetKind::kInt32: {
      const auto value = number<std::int32_t>();
      return leaf_->scale > 0    ? decimalOf(value, leaf_->scale)
             : leaf_->isUnsigned ? digitsOf(static_cast<std::uint32_t>(value))
                                 : digitsOf(value);
    }
    case ParquetKind::kInt64: {
      const auto value = number<std::int64_t>();
      return leaf_->scale > 0    ? decimalOf(value, leaf_->scale)
             : leaf_->isUnsigned ? digitsOf(static_cast<std::uint64_t>(value))
                                 : digitsOf(value);
    }
    case ParquetKind::kFloat:
      return realOf(number<float>());
    case ParquetKind::kDouble:
      return realOf(number<double>());
    default:
      break;
  }
  const auto size = number<std::uint32_t>();
  if (size > bytes_.size() - at_) {
    throw PageDamaged();
  }
  at_ += size;
  return std::string(bytes_.substr(at_ - size, size));
}

}  // namespace torsio
