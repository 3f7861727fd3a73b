// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

/// Filtered magnitudes of force or torque over a time range.
struct Loading {
  double mean = 0.0;  ///< time average: impulse / duration, not the sum / N
  double peak = 0.0;
  double p95 = 0.0;      ///< quantile of type 7
  double impulse = 0.0;  ///< integral of the magnitude
  double rms = 0.0;      ///< by trapezoids
  double largestRate = 0.0;
  double rmsRate = 0.0;
};
/// Measures loads from their magnitudes. Undefined for fewer than two samples.
[[nodiscard]] Outcome<Loading> loadingOf(std::span<const double> magnitude, double rate_Hz);

inline constexpr double kMergeViolations_s = 0.050;
inline constexpr double kIgnoreViolations_s = 0.010;

struct Violations {
  int count = 0;               ///< excursions; merged if less than 50 ms apart, ignored if shorter than 10 ms
  double time_s = 0.0;         ///< all samples above the limit, including ignored excursions
  double excessImpulse = 0.0;  ///< integral of max(0, value - limit)
};
[[nodiscard]] Violations violationsOf(std::span<const double> value, double limit, double rate_Hz);

struct TwistWork {
  double delivered_J = 0.0;  ///< integral of positive torque times angular rate: work on the tissue
  double returned_J = 0.0;   ///< by the tissue, positive
  double loop_J = 0.0;       ///< delivered minus returned: area of the torque-angle loop
};
/// Computes the work of a twist, torque (N m) over angle (rad), by trapezoids. Undefined for fewer than two
/// samples.
[[nodiscard]] Outcome<TwistWork> twistWork(std::span<const double> torque_Nm,
                                           std::span<const double> angle_rad);

}  // namespace torsio
