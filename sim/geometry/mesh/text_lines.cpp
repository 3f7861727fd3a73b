// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/text_lines.h"

#include <charconv>
#include <system_error>

namespace torsio {

namespace {

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

}  // namespace

std::optional<std::string_view> TextLines::next() {
  if (rest_.empty()) {
    return std::nullopt;
  }
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++number_;
  return line;
}

void splitWords(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  std::size_t i = 0;
  while (true) {
    while (i < line.size() && isSpace(line[i])) {
      ++i;
    }
    if (i == line.size()) {
      return;
    }
    const std::size_t start = i;
    while (i < line.size() && !isSpace(line[i])) {
      ++i;
    }
    words.push_back(line.substr(start, i - start));
  }
}

std::optional<std::uint64_t> parseCount(std::string_view word) {
  constexpr std::uint64_t kMost = 1'000'000'000'000ULL;
  std::uint64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') {
      return std::nullopt;
    }
    value = value * 10 + static_cast<std::uint64_t>(c - '0');
    if (value > kMost) {
      value = kMost;
    }
  }
  if (word.empty()) {
    return std::nullopt;
  }
  return value;
}

bool isNumber(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool outOfRange = failed == std::errc::result_out_of_range;
  return (failed == std::errc() || outOfRange) && end == word.data() + word.size();
}

}  // namespace torsio
