// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/base/ids.h"

namespace torsio {

/// A sentence with places for its arguments: `Text("trial %1 is sealed", id)`. English stands in the
/// pattern; whoever shows the text may replace the pattern by that of another language before the arguments
/// enter. Arguments are texts themselves. A plain literal or string is a text as well.
/// tests/support/service_texts.h reads the patterns out of the sources.
class Text {
 public:
  Text() = default;
  Text(const char* words) : pattern_(words) {}             // NOLINT(google-explicit-constructor)
  Text(std::string words) : pattern_(std::move(words)) {}  // NOLINT(google-explicit-constructor)
  template <typename Tag>
  Text(const Id<Tag>& id) : pattern_(id.text()) {}  // NOLINT(google-explicit-constructor)
  /// `%1` to `%9` of the pattern stand for the arguments: texts, strings and whole numbers.
  template <typename... Rest>
  Text(std::string pattern, const auto& first, const Rest&... rest)
      : pattern_(std::move(pattern)), arguments_{argument(first), argument(rest)...} {}

  [[nodiscard]] const std::string& pattern() const noexcept { return pattern_; }
  [[nodiscard]] const std::vector<Text>& arguments() const noexcept { return arguments_; }
  [[nodiscard]] bool empty() const noexcept { return pattern_.empty(); }
  /// Returns the English sentence with its arguments.
  [[nodiscard]] std::string str() const;
  /// Compares what both texts say in English.
  friend bool operator==(const Text& a, const Text& b) { return a.str() == b.str(); }
  friend std::ostream& operator<<(std::ostream& out, const Text& text) { return out << text.str(); }

 private:
  static Text argument(const std::convertible_to<Text> auto& text) { return text; }
  static Text argument(std::string_view words) { return std::string(words); }
  static Text argument(std::integral auto number) { return std::to_string(number); }

  std::string pattern_;
  std::vector<Text> arguments_;
};

/// Returns `pattern` with `%1` to `%9` replaced by the arguments in one pass; a place without an argument
/// stays.
[[nodiscard]] std::string filledIn(std::string_view pattern, const std::vector<std::string>& arguments);

}  // namespace torsio
