// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/base/text.h"

#include <cstddef>

namespace torsio {

std::string Text::str() const {
  if (arguments_.empty()) {
    return pattern_;
  }
  std::vector<std::string> words;
  words.reserve(arguments_.size());
  for (const Text& argument : arguments_) {
    words.push_back(argument.str());
  }
  return filledIn(pattern_, words);
}

std::string filledIn(std::string_view pattern, const std::vector<std::string>& arguments) {
  std::string filled;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char next = i + 1 < pattern.size() ? pattern[i + 1] : '\0';
    const auto place = static_cast<std::size_t>(next - '1');
    if (pattern[i] == '%' && next >= '1' && next <= '9' && place < arguments.size()) {
      filled += arguments[place];
      ++i;
    } else {
      filled += pattern[i];
    }
  }
  return filled;
}

}  // namespace torsio
