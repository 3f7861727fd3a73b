// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assessment/statistics/values.h"
#include "sim/core/angle.h"
#include "sim/core/vec3.h"

namespace torsio {

/// Sums the distances between successive positions, in their unit. Filter the positions first: noise adds
/// length.
[[nodiscard]] double pathLength(std::span<const Vec3> positions);
/// Sums the absolute changes of an angle.
[[nodiscard]] double angularPath(std::span<const double> angles);
/// Computes ideal / actual path, in (0, 1]. Undefined without movement.
[[nodiscard]] Outcome<double> economy(double ideal, double actual);

inline constexpr double kIdleAtLeast_s = 0.2;
inline constexpr double kIdleTip_m_per_s = 0.005;
inline constexpr double kIdleTwist_rad_per_s = radians(2.0);

/// Sums the time with a speed below `threshold` in stretches of at least 0.2 s.
[[nodiscard]] double idleTime(std::span<const double> speed, double threshold, double rate_Hz,
                              double atLeast_s = kIdleAtLeast_s);

struct SparcOptions {
  int paddingLevel = 4;
  double cutoff_Hz = 10.0;
  double amplitudeThreshold = 0.05;
};
/// Computes the spectral arc length of a speed profile (Balasubramanian 2012, 2015): closer to 0 is smoother,
/// about -1.4 for a single bell-shaped movement. For a single movement of at most a minute. Undefined without
/// movement or for a longer signal.
[[nodiscard]] Outcome<double> spectralArcLength(std::span<const double> speed, double rate_Hz,
                                                const SparcOptions& options = {});

/// Computes the logarithm of dimensionless jerk of a speed profile: -ln(T^3 / peak^2 x integral of
/// (d2v/dt2)^2), by trapezoids over all samples with linearly extrapolated ends. Depends on the filter, which
/// must be stated with it. Undefined without movement.
[[nodiscard]] Outcome<double> logDimensionlessJerk(std::span<const double> speed, double rate_Hz);

inline constexpr double kPeakProminence = 0.05;  ///< relative to the maximum speed
inline constexpr double kPeakDistance_s = 0.1;

/// Finds the indices of speed peaks with a prominence of at least 5 % of the maximum, at least 0.1 s apart
/// (of closer ones the higher is kept).
[[nodiscard]] std::vector<std::size_t> speedPeaks(std::span<const double> speed, double rate_Hz);

/// Computes the root mean square deviation of the tip's distance from the twist axis: how well it follows a
/// circle.
[[nodiscard]] Outcome<double> axisWander(std::span<const Vec3> positions, const Vec3& axisPoint,
                                         const Vec3& axis);

}  // namespace torsio
