// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace torsio {

/// Streaming BLAKE2b-256 (libsodium): the content hash of trials, organs and exports.
class Digest {
 public:
  using Value = std::array<std::uint8_t, 32>;

  Digest();
  void update(std::span<const std::byte> bytes) noexcept;
  void update(std::string_view text) noexcept;
  /// Adds the little-endian bytes of a number; of a double its bit pattern.
  void update(std::int64_t value) noexcept;
  void update(double value) noexcept;
  /// Returns the hash of everything added so far; further updates may follow.
  [[nodiscard]] Value value() const noexcept;
  [[nodiscard]] std::string hex() const;

 private:
  alignas(64) std::array<std::byte, 384> state_{};
};

[[nodiscard]] std::string toHex(std::span<const std::uint8_t> bytes);

}  // namespace torsio
