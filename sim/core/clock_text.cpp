// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/clock_text.h"

#include <algorithm>
#include <cmath>

#include "sim/core/time_units.h"

namespace torsio {

std::string clockText(std::int64_t time_us) {
  const std::int64_t seconds = time_us / kSecond_us;
  const std::string rest = std::to_string(seconds % 60);
  return std::to_string(seconds / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

std::string clockLeftText(std::int64_t left_us) {
  return clockText(std::max<std::int64_t>(0, left_us) + kSecond_us - 1);
}

std::string clockTenthsText(double time_s) {
  const auto tenths = static_cast<std::int64_t>(std::llround(10.0 * time_s));  // 59.96 s are 1:00.0
  return clockText(tenths / 10 * kSecond_us) + "." + std::to_string(tenths % 10);
}

}  // namespace torsio
