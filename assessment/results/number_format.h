// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

/// Formats a number with fixed decimals and a decimal point, independent of the locale; never "-0.00".
[[nodiscard]] std::string formatFixed(double value, int decimals);
/// Formats a number as the shortest text that reads back as the same double, for machine-readable tables.
[[nodiscard]] std::string formatExact(double value);
/// Formats a p value as in journals: "< 0.001", otherwise three decimals.
[[nodiscard]] std::string formatP(double p);
/// Formats a time in microseconds since 1970 as "2026-01-05 08:00 UTC".
[[nodiscard]] std::string formatUtc(std::int64_t utc_us);

}  // namespace torsio
