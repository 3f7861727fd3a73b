// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace torsio {

/// Formats a number with fixed decimals and a point as separator, the same on every machine whatever its
/// locale; never "-0.00".
[[nodiscard]] std::string formatFixed(double value, int decimals);
/// Formats a number with fixed decimals; "not defined" when there is no value.
[[nodiscard]] std::string formatFixed(const std::optional<double>& value, int decimals);
/// Formats a number as the shortest text that reads back as the same double, for machine-readable tables.
[[nodiscard]] std::string formatExact(double value);
/// Formats a p value as journals print it: "< 0.001", else three decimals.
[[nodiscard]] std::string formatP(double p);
/// Formats a time in microseconds since 1970: "2026-01-05 08:00 UTC".
[[nodiscard]] std::string formatUtc(std::int64_t utc_us);

}  // namespace torsio
