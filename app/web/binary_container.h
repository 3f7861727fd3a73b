// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

namespace torsio::web {

/// Container of numeric arrays for a page: "TRS1", the length of a JSON text (32 bits), the text, the arrays,
/// all little-endian and aligned to four bytes. The text describes the arrays: {"meta": ..., "arrays":
/// [{"name", "type", "offset", "count", "delta", "scale"}]}, with offsets from the end of the text.
class BinaryContainer {
 public:
  [[nodiscard]] nlohmann::json& meta() noexcept { return meta_; }

  void add(const std::string& name, std::span<const float> values) { put(name, "f32", values); }
  void add(const std::string& name, std::span<const std::int16_t> values) { put(name, "i16", values); }
  void add(const std::string& name, std::span<const std::uint32_t> values) { put(name, "u32", values); }
  void add(const std::string& name, std::span<const std::uint8_t> values) { put(name, "u8", values); }

  /// Adds values as differences to the one `stride` before ("delta"), which compresses smooth rows well.
  void addDifferences(const std::string& name, std::span<const std::int16_t> values, std::size_t stride);
  void addDifferences(const std::string& name, std::span<const std::uint32_t> values, std::size_t stride);
  /// Adds values as multiples of `step` (in 16 bits), stored as differences; the page multiplies by "scale".
  void addMultiples(const std::string& name, std::span<const float> values, float step, std::size_t stride);

  [[nodiscard]] std::string bytes() const;

 private:
  template <typename Value>
  void put(const std::string& name, const char* type, std::span<const Value> values);
  template <typename Value>
  void putDifferences(const std::string& name, const char* type, std::span<const Value> values,
                      std::size_t stride);

  nlohmann::json meta_ = nlohmann::json::object();
  nlohmann::json arrays_ = nlohmann::json::array();
  std::string data_;
};

/// Returns `bytes` as a reproducible gzip stream (RFC 1952), without name and time.
[[nodiscard]] std::string gzipped(const std::string& bytes);

}  // namespace torsio::web
