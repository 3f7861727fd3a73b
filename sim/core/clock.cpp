// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/clock.h"

#include <chrono>

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

}  // namespace torsio
