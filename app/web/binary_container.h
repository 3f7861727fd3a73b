// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

namespace torsio::web {

/// Arrays of numbers for a page: "TRS1", the length of a JSON text (32 bits), the text, then the arrays, all
/// little-endian and aligned to four bytes. The text says what lies where: {"meta": ..., "arrays": [{"name",
/// "type", "offset", "count", "delta", "scale"}]}, offsets from the end of the text.
class BinaryContainer {
 public:
  [[nodiscard]] nlohmann::json& meta() noexcept { return meta_; }

  void add(const std::string& name, std::span<const float> values) { put(name, "f32", values); }
  void add(const std::string& name, std::span<const std::int16_t> values) { put(name, "i16", values); }
  void add(const std::string& name, std::span<const std::uint32_t> values) { put(name, "u32", values); }
  void add(const std::string& name, std::span<const std::uint8_t> values) { put(name, "u8", values); }

  /// As differences to the value `stride` before, which packs smooth rows to a fraction: "delta" says so.
  void addDifferences(const std::string& name, std::span<const std::int16_t> values, std::size_t stride);
  void addDifferences(const std::string& name, std::span<const std::uint32_t> values, std::size_t stride);
  /// Multiples of `step` that fit into 16 bits, as differences; the page gets them times "scale".
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

/// Returns `bytes` as a gzip stream (RFC 1952) without name and time: the same each time.
[[nodiscard]] std::string gzipped(const std::string& bytes);

}  // namespace torsio::web
