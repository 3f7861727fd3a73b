// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/digest.h"

#include <bit>
#include <cstring>

#include <sodium.h>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

crypto_generichash_state* stateOf(std::byte* bytes) {
  static_assert(sizeof(crypto_generichash_state) <= 384);
  return reinterpret_cast<crypto_generichash_state*>(bytes);
}

}  // namespace

Digest::Digest() {
  TORSIO_EXPECTS(sodium_init() >= 0);
  crypto_generichash_init(stateOf(state_.data()), nullptr, 0, sizeof(Value));
}

void Digest::update(std::span<const std::byte> bytes) noexcept {
  crypto_generichash_update(stateOf(state_.data()), reinterpret_cast<const unsigned char*>(bytes.data()),
                            bytes.size());
}

void Digest::update(std::string_view text) noexcept {
  update(std::as_bytes(std::span(text)));
}

void Digest::update(std::int64_t value) noexcept {
  std::array<std::byte, 8> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::byte>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFFU);
  }
  update(std::span<const std::byte>(bytes));
}

void Digest::update(double value) noexcept {
  update(std::bit_cast<std::int64_t>(value));
}

Digest::Value Digest::value() const noexcept {
  Digest copy(*this);
  Value out{};
  crypto_generichash_final(stateOf(copy.state_.data()), out.data(), out.size());
  return out;
}

std::string Digest::hex() const {
  return toHex(value());
}

std::string toHex(std::span<const std::uint8_t> bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes) {
    text.push_back(kDigits[byte >> 4]);
    text.push_back(kDigits[byte & 0xF]);
  }
  return text;
}

}  // namespace torsio
