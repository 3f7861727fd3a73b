// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace torsio {

/// Writes a number with three significant digits, for messages: 0.367, 1.3e+09. Any thread.
[[nodiscard]] inline std::string shortNumber(double value) {
  constexpr int kDigits = 3;
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kDigits);
  return {text.data(), end.ptr};
}

}  // namespace torsio
