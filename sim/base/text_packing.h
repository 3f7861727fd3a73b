// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/text.h"

namespace torsio {

/// Writes numbers and texts as bytes, for another process of this program on this machine.
class TextPacker {
 public:
  void number(double value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value)); }
  void text(const std::string& value) {
    number(static_cast<double>(value.size()));
    bytes_ += value;
  }
  void text(const Text& value) {
    text(value.pattern());
    number(static_cast<double>(value.arguments().size()));
    for (const Text& argument : value.arguments()) {
      text(argument);
    }
  }
  template <typename Part>
  void list(const std::vector<Part>& parts) {
    number(static_cast<double>(parts.size()));
    for (const Part& part : parts) {
      text(part);
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
    const std::size_t wanted = count(kLongestText);
    const std::size_t size = std::min(wanted, bytes_.size() - at_);
    value = bytes_.substr(at_, size);
    at_ += size;
  }
  void text(Text& value, int depth = 0) {
    std::string pattern;
    text(pattern);
    const std::size_t size = depth < kDeepestText ? count(kMostParts) : 0;
    std::vector<Text> arguments(size);
    for (Text& argument : arguments) {
      text(argument, depth + 1);
    }
    value = Text::restored(pattern, std::move(arguments));
  }
  template <typename Part>
  void list(std::vector<Part>& parts) {
    parts.resize(count(kMostParts));
    for (Part& part : parts) {
      text(part);
    }
  }

 private:
  static constexpr std::size_t kMostParts = 64;
  static constexpr int kDeepestText = 6;
  static constexpr std::size_t kLongestText = 8'192;

  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace torsio
