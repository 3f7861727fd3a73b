// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/text.h"

#include <cstddef>

#include "sim/core/plain_text.h"

namespace torsio {

std::string Text::str() const {
  if (arguments_.empty()) {
    return plainText(pattern_);
  }
  std::vector<std::string> words;
  words.reserve(arguments_.size());
  for (const Text& argument : arguments_) {
    words.push_back(argument.str());
  }
  return filledIn(pattern_, words);
}

namespace {

/// Appends "one" of "{one|many}" when `number` is 1, else "many". `at` is the place of the brace; returns the
/// place of the one that closes it, or `at` itself where the pattern has no such pair.
std::size_t appendPlural(std::string& filled, std::string_view pattern, std::size_t at,
                         std::string_view number) {
  const std::size_t end = pattern.find('}', at);
  const std::size_t bar = pattern.substr(0, end).find('|', at);
  if (end == std::string_view::npos || bar == std::string_view::npos) {
    return at;
  }
  filled += number == "1" ? pattern.substr(at + 1, bar - at - 1) : pattern.substr(bar + 1, end - bar - 1);
  return end;
}

}  // namespace

std::string filledIn(std::string_view pattern, const std::vector<std::string>& arguments) {
  std::string filled;
  std::string_view number;  // the argument of the last place
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char next = i + 1 < pattern.size() ? pattern[i + 1] : '\0';
    const auto place = static_cast<std::size_t>(next - '1');
    if (pattern[i] == '%' && next >= '1' && next <= '9' && place < arguments.size()) {
      number = arguments[place];
      filled += number;
      ++i;
      continue;
    }
    if (pattern[i] == '{' && !number.empty()) {
      if (const std::size_t end = appendPlural(filled, pattern, i, number); end != i) {
        i = end;
        continue;
      }
    }
    filled += pattern[i];
  }
  return filled;
}

}  // namespace torsio
