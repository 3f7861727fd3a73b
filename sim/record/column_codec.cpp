// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/column_codec.h"

#include <algorithm>
#include <array>
#include <bit>

#include "sim/core/error.h"

namespace torsio {

namespace {

// A packed column: order, width, the first values of each order as variable-length integers, then the planes.
constexpr std::size_t kLargestOrder = 4;
constexpr std::size_t kLargestWidth = 8;
constexpr std::size_t kLargestVarint = 10;

[[noreturn]] void damagedColumn() {
  throw Error(ErrorCode::kBadData, Text::verbatim("a column of samples does not unpack"),
              Text::verbatim("recorded chunk"),
              Text::verbatim("The recording is damagedColumn: restore it from a copy"));
}

/// Small numbers of either sign become small unsigned numbers: 0, -1, 1, -2 ... to 0, 1, 2, 3 ...
std::uint64_t fold(std::uint64_t difference) noexcept {
  return (difference << 1) ^ (0 - (difference >> 63));
}
std::uint64_t unfold(std::uint64_t folded) noexcept {
  return (folded >> 1) ^ (0 - (folded & 1));
}

/// Replaces values[k..] by their differences; unsigned, so that any overflow wraps and is undone.
void difference(std::span<std::uint64_t> values, std::size_t k) noexcept {
  for (std::size_t i = values.size(); i-- > k;) {
    values[i] -= values[i - 1];
  }
}

std::uint64_t costOf(std::span<const std::uint64_t> values, std::size_t first) noexcept {
  std::uint64_t bits = 0;
  for (std::size_t i = first; i < values.size(); ++i) {
    bits += static_cast<std::uint64_t>(std::bit_width(fold(values[i])));
  }
  return bits;
}

void putVarint(std::uint64_t value, std::vector<std::uint8_t>& out) {
  for (; value >= 0x80; value >>= 7) {
    out.push_back(static_cast<std::uint8_t>(value | 0x80));
  }
  out.push_back(static_cast<std::uint8_t>(value));
}

std::uint8_t takeByte(std::span<const std::uint8_t>& in) {
  if (in.empty()) {
    damagedColumn();
  }
  const std::uint8_t byte = in.front();
  in = in.subspan(1);
  return byte;
}

std::uint64_t takeVarint(std::span<const std::uint8_t>& in) {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    const std::uint8_t byte = takeByte(in);
    value |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
    if ((byte & 0x80) == 0) {
      return value;
    }
  }
  damagedColumn();
}

}  // namespace

void packColumn(std::span<const std::int64_t> column, std::vector<std::uint8_t>& packed) {
  const std::size_t n = column.size();
  std::vector<std::uint64_t> values(n);
  std::transform(column.begin(), column.end(), values.begin(),
                 [](std::int64_t v) { return static_cast<std::uint64_t>(v); });
  std::vector<std::uint64_t> best = values;
  std::size_t order = 0;
  std::uint64_t lowest = costOf(values, 0);
  for (std::size_t k = 1; k <= std::min(kLargestOrder, n); ++k) {
    difference(values, k);
    const std::uint64_t cost = costOf(values, k);
    if (cost >= lowest) {
      continue;
    }
    lowest = cost;
    order = k;
    best = values;
  }

  std::uint64_t all = 0;
  for (std::size_t i = order; i < n; ++i) {
    all |= fold(best[i]);
  }
  const auto width = static_cast<std::size_t>((std::bit_width(all) + 7) / 8);
  packed.push_back(static_cast<std::uint8_t>(order));
  packed.push_back(static_cast<std::uint8_t>(width));
  for (std::size_t i = 0; i < order; ++i) {
    putVarint(fold(best[i]), packed);
  }
  for (std::size_t plane = 0; plane < width; ++plane) {
    for (std::size_t i = order; i < n; ++i) {
      packed.push_back(static_cast<std::uint8_t>(fold(best[i]) >> (8 * plane)));
    }
  }
}

std::span<const std::uint8_t> unpackColumn(std::span<const std::uint8_t> packed,
                                           std::span<std::int64_t> column) {
  const std::size_t n = column.size();
  const std::size_t order = takeByte(packed);
  const std::size_t width = takeByte(packed);
  if (order > std::min(kLargestOrder, n) || width > kLargestWidth) {
    damagedColumn();
  }
  std::vector<std::uint64_t> values(n, 0);
  for (std::size_t i = 0; i < order; ++i) {
    values[i] = unfold(takeVarint(packed));
  }
  const std::size_t coded = n - order;
  if (packed.size() < width * coded) {
    damagedColumn();
  }
  for (std::size_t plane = 0; plane < width; ++plane) {
    for (std::size_t i = 0; i < coded; ++i) {
      values[order + i] |= static_cast<std::uint64_t>(packed[plane * coded + i]) << (8 * plane);
    }
  }
  for (std::size_t i = order; i < n; ++i) {
    values[i] = unfold(values[i]);
  }
  for (std::size_t k = order; k >= 1; --k) {
    for (std::size_t i = k; i < n; ++i) {
      values[i] += values[i - 1];
    }
  }
  std::transform(values.begin(), values.end(), column.begin(),
                 [](std::uint64_t v) { return static_cast<std::int64_t>(v); });
  return packed.subspan(width * coded);
}

std::size_t largestPackedColumn(std::size_t length) noexcept {
  return 2 + kLargestOrder * kLargestVarint + kLargestWidth * length;
}

}  // namespace torsio
