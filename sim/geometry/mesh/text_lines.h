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

  /// The next line without its end; nothing after the last.
  [[nodiscard]] std::optional<std::string_view> next();
  /// Number of the line returned last, from 1.
  [[nodiscard]] std::uint64_t number() const noexcept { return number_; }
  /// What has not been returned yet.
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

 private:
  std::string_view rest_;
  std::uint64_t number_ = 0;
};

/// The words of a line between white space. `words` is cleared first: one vector serves a whole file.
void splitWords(std::string_view line, std::vector<std::string_view>& words);

/// A non-negative integer of digits only; above 10^12 the answer is 10^12, so that products cannot overflow.
[[nodiscard]] std::optional<std::uint64_t> parseCount(std::string_view word);

/// True for a number as C reads it, including nan and inf.
[[nodiscard]] bool isNumber(std::string_view word);

}  // namespace torsio
