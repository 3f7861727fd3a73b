// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/id_source.h"

#include <array>
#include <span>

#include <sodium.h>

#include "sim/core/contracts.h"
#include "sim/core/digest.h"

namespace torsio {

namespace {

using Bytes = std::array<std::uint8_t, 16>;

constexpr std::array<std::size_t, 4> kDashes{8, 13, 18, 23};

std::string uuidText(Bytes bytes) {
  bytes[6] = static_cast<std::uint8_t>((bytes[6] & 0x0FU) | 0x40U);  // version 4
  bytes[8] = static_cast<std::uint8_t>((bytes[8] & 0x3FU) | 0x80U);  // variant 10
  std::string text = toHex(bytes);
  for (const std::size_t position : kDashes) {
    text.insert(position, 1, '-');
  }
  return text;
}

}  // namespace

std::string SystemIdSource::newUuid() {
  TORSIO_EXPECTS(sodium_init() >= 0);
  Bytes bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return uuidText(bytes);
}

std::string SeededIdSource::newUuid() {
  Bytes bytes{};
  for (std::size_t half = 0; half < 2; ++half) {
    const std::uint64_t word = random_.next();
    for (std::size_t i = 0; i < 8; ++i) {
      bytes[8 * half + i] = static_cast<std::uint8_t>(word >> (8 * i));
    }
  }
  return uuidText(bytes);
}

}  // namespace torsio
