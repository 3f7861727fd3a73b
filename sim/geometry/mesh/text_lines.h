// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace torsio {

/// Walks over the lines of a text, with or without a last line end.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}

  /// Returns the next line without its end; nothing after the last.
  [[nodiscard]] std::optional<std::string_view> next();
  /// Returns the number of the line returned last, from 1.
  [[nodiscard]] std::uint64_t number() const noexcept { return number_; }
  /// Returns the text after the line returned last.
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

 private:
  std::string_view rest_;
  std::uint64_t number_ = 0;
};

/// Splits a line into its words between white space. `words` is cleared first: one vector serves a whole
/// file.
void splitWords(std::string_view line, std::vector<std::string_view>& words);

/// Reads a non-negative integer of digits only; above 10^12 the result is 10^12, so that products cannot
/// overflow.
[[nodiscard]] std::optional<std::uint64_t> parseCount(std::string_view word);

/// Tells whether a word is a number as C reads one, including nan and inf.
[[nodiscard]] bool isNumber(std::string_view word);

}  // namespace torsio
