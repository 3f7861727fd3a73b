// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/report/number_format.h"

#include <array>
#include <charconv>
#include <cmath>

#include "sim/base/contracts.h"

namespace torsio {

std::string formatFixed(double value, int decimals) {
  TORSIO_EXPECTS(std::isfinite(value));
  std::array<char, 400> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), end.ptr);
  if (text.front() == '-' && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string formatFixed(const std::optional<double>& value, int decimals) {
  return value ? formatFixed(*value, decimals) : std::string("not defined");
}

std::string formatExact(double value) {
  TORSIO_EXPECTS(std::isfinite(value));
  if (value == 0.0) return "0";
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), end.ptr);
}

std::string formatP(double p) {
  return p < 0.001 ? std::string("< 0.001") : formatFixed(p, 3);
}

std::string sentence(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

}  // namespace torsio
