// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/tables/export_table.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <system_error>

#include "assessment/results/number_format.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr double kLargest = 1.79769313486231e308;  // with 15 digits

std::string isoTime(std::int64_t utc_us) {
  const std::chrono::sys_time<std::chrono::microseconds> at{std::chrono::microseconds(utc_us)};
  const auto day = std::chrono::floor<std::chrono::days>(at);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss time(at - day);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%06dZ",
                static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()), static_cast<int>(time.hours().count()),
                static_cast<int>(time.minutes().count()), static_cast<int>(time.seconds().count()),
                static_cast<int>(time.subseconds().count()));
  return text.data();
}

}  // namespace

double sheetNumber(double value) {
  std::array<char, 40> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 15);
  TORSIO_EXPECTS(error == std::errc());
  double rounded = 0.0;
  const bool tooLarge = std::from_chars(digits.data(), end, rounded).ec == std::errc::result_out_of_range;
  return tooLarge ? std::copysign(kLargest, value) : rounded;
}

std::string cellText(const ExportCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) {
    return *text;
  }
  if (const auto* number = std::get_if<double>(&cell)) {
    return formatExact(*number);
  }
  if (const auto* utc_us = std::get_if<std::int64_t>(&cell)) {
    return isoTime(*utc_us);
  }
  return {};
}

}  // namespace torsio
