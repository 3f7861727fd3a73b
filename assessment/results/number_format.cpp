// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/number_format.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "sim/core/contracts.h"

namespace torsio {

std::string formatFixed(double value, int decimals) {
  TORSIO_EXPECTS(std::isfinite(value));
  std::array<char, 400> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), end.ptr);
  if (text.front() == '-' && text.find_first_of("123456789") == std::string::npos) {
    text.erase(0, 1);
  }
  return text;
}

std::string formatExact(double value) {
  TORSIO_EXPECTS(std::isfinite(value));
  if (value == 0.0) {
    return "0";
  }
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), end.ptr);
}

std::string formatP(double p) {
  return p < 0.001 ? std::string("< 0.001") : formatFixed(p, 3);
}

std::string formatUtc(std::int64_t utc_us) {
  const std::chrono::sys_time<std::chrono::microseconds> at{std::chrono::microseconds(utc_us)};
  const auto day = std::chrono::floor<std::chrono::days>(at);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss time(std::chrono::floor<std::chrono::minutes>(at - day));
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u %02d:%02d UTC", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()));
  return text.data();
}

}  // namespace torsio
