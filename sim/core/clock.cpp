// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/core/clock.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sim/core/time_units.h"

namespace torsio {

namespace {

template <typename AnyClock>
std::int64_t microseconds() noexcept {
  return std::chrono::duration_cast<std::chrono::microseconds>(AnyClock::now().time_since_epoch()).count();
}

}  // namespace

std::int64_t MonotonicClock::now_us() const noexcept {
  return microseconds<std::chrono::steady_clock>();
}

std::int64_t utcNow_us() noexcept {
  return microseconds<std::chrono::system_clock>();
}

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
