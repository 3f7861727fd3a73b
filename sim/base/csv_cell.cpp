// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/base/csv_cell.h"

#include <charconv>
#include <system_error>
#include <utility>

namespace torsio {

namespace {

bool isNumber(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

}  // namespace

std::string csvQuoted(std::string text, std::string_view separators) {
  if (text.find_first_of("\"\r\n") == std::string::npos &&
      text.find_first_of(separators) == std::string::npos) {
    return text;
  }
  std::string quoted(1, '"');
  for (const char c : text) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + '"';
}

std::string csvCell(std::string text) {
  constexpr std::string_view kBeginsFormula = "=+-@\t\r";
  if (!text.empty() && kBeginsFormula.find(text.front()) != std::string_view::npos && !isNumber(text)) {
    text.insert(text.begin(), '\'');
  }
  return csvQuoted(std::move(text), ",;");
}

}  // namespace torsio
