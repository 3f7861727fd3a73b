// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/portable_math.h"

namespace torsio {

// Inside Torsio every angle is in radians. Degrees stand in files that people write, on screens and in
// reports; this is the one place that converts.

inline constexpr double kTurn = 2.0 * kPi;  ///< a whole turn, radians
inline constexpr double kRadiansPerDegree = kPi / 180.0;
inline constexpr double kDegreesPerRadian =
    180.0 / kPi;  ///< as the scale of an axis; otherwise use degrees()

/// Converts an angle in degrees to radians.
[[nodiscard]] constexpr double radians(double angle_deg) noexcept {
  return angle_deg * kRadiansPerDegree;
}

/// Converts an angle in radians to degrees. Undoes radians() to within rounding: round before showing whole
/// ones.
[[nodiscard]] constexpr double degrees(double angle_rad) noexcept {
  return angle_rad / kRadiansPerDegree;
}

}  // namespace torsio
