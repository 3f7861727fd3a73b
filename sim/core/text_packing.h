// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// How deep texts may lie in one another, how many in a list, how many bytes each.
inline constexpr int kDeepestPackedText = 24;
inline constexpr std::size_t kMaxPackedParts = 64;
inline constexpr std::size_t kLongestPackedText = 8'192;

/// Writes numbers and texts as bytes, for another process of this program on this machine.
class TextPacker {
 public:
  void number(double value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value)); }
  /// At most kLongestPackedText bytes of it.
  void text(const std::string& value) {
    const std::size_t size = std::min(value.size(), kLongestPackedText);
    number(static_cast<double>(size));
    bytes_.append(value, 0, size);
  }
  /// What lies deeper than kDeepestPackedText, and lists are as deep as long, comes in English.
  void text(const Text& value, int depth = 0) {
    if (depth == kDeepestPackedText) {
      text(value.str());
      number(0.0);
      return;
    }
    text(value.pattern());
    const std::size_t told = std::min(value.arguments().size(), kMaxPackedParts);
    number(static_cast<double>(told));
    for (std::size_t n = 0; n < told; ++n) {
      text(value.arguments()[n], depth + 1);
    }
  }
  /// At most kMaxPackedParts of them.
  template <typename Part>
  void list(const std::vector<Part>& parts) {
    const std::size_t told = std::min(parts.size(), kMaxPackedParts);
    number(static_cast<double>(told));
    for (std::size_t n = 0; n < told; ++n) {
      text(parts[n]);
    }
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads what TextPacker wrote. Bytes that are missing or out of range read as 0 and empty: sizes are
/// checked.
class TextUnpacker {
 public:
  explicit TextUnpacker(const std::string& bytes) : bytes_(bytes) {}
  double number() {
    double value = 0.0;
    if (bytes_.size() - at_ >= sizeof(value)) {
      std::memcpy(&value, bytes_.data() + at_, sizeof(value));
      at_ += sizeof(value);
    }
    return value;
  }
  std::size_t count(std::size_t most) {
    const double value = number();
    return value > 0.0 && value <= static_cast<double>(most) ? static_cast<std::size_t>(value) : 0;
  }
  void text(std::string& value) {
    const std::size_t wanted = count(kLongestPackedText);
    const std::size_t size = std::min(wanted, bytes_.size() - at_);
    value = bytes_.substr(at_, size);
    at_ += size;
  }
  void text(Text& value, int depth = 0) {
    std::string pattern;
    text(pattern);
    const std::size_t parts = count(kMaxPackedParts);
    std::vector<Text> arguments(depth < kDeepestPackedText ? parts : 0);
    for (Text& argument : arguments) {
      text(argument, depth + 1);
    }
    value = Text::restored(pattern, std::move(arguments));
  }
  template <typename Part>
  void list(std::vector<Part>& parts) {
    parts.resize(count(kMaxPackedParts));
    for (Part& part : parts) {
      text(part);
    }
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace torsio
