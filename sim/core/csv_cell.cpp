// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/csv_cell.h"

#include <algorithm>
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

bool needsQuotes(std::string_view text, std::string_view separators) {
  return std::any_of(text.begin(), text.end(), [separators](char c) {
    return c == '"' || c == '\r' || c == '\n' || separators.find(c) != std::string_view::npos;
  });
}

bool readsAsFormula(std::string_view text) {
  constexpr std::string_view kBeginsFormula = "=+-@\t\r";
  return !text.empty() && kBeginsFormula.find(text.front()) != std::string_view::npos && !isNumber(text);
}

constexpr std::string_view kSeparators = ",;";

}  // namespace

std::string csvQuoted(std::string text, std::string_view separators) {
  if (!needsQuotes(text, separators)) {
    return text;
  }
  std::string quoted(1, '"');
  for (const char c : text) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + '"';
}

std::string csvCell(std::string text) {
  if (readsAsFormula(text)) {
    text.insert(text.begin(), '\'');
  }
  return csvQuoted(std::move(text), kSeparators);
}

void appendCsvCell(std::string& line, const std::string& text) {
  if (readsAsFormula(text) || needsQuotes(text, kSeparators)) {
    line += csvCell(text);
  } else {
    line += text;
  }
}

}  // namespace torsio
