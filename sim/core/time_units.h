// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio {

// Spans of time in microseconds, the unit of every stored time.
inline constexpr std::int64_t kSecond_us = 1'000'000;
inline constexpr std::int64_t kMinute_us = 60 * kSecond_us;
inline constexpr std::int64_t kHour_us = 60 * kMinute_us;
inline constexpr std::int64_t kDay_us = 24 * kHour_us;

/// Time between two ticks of the servo, and so between two samples of every recording: 1 kHz, the rate at
/// which haptic devices are driven.
inline constexpr std::int64_t kTickPeriod_us = 1'000;

/// Counts the whole ticks that fit into a span.
[[nodiscard]] constexpr std::int64_t ticksIn(double span_s) noexcept {
  return static_cast<std::int64_t>(span_s * 1e6) / kTickPeriod_us;
}

/// Gives the length of so many ticks, s.
[[nodiscard]] constexpr double spanOf_s(std::int64_t ticks) noexcept {
  return static_cast<double>(ticks * kTickPeriod_us) * 1e-6;
}

}  // namespace torsio
