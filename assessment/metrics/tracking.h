// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "assessment/statistics/values.h"

namespace torsio {

/// How a target angle was reached and kept. Angles in one unit, times in seconds from the first sample.
struct TargetApproach {
  double overshoot = 0.0;  ///< beyond the target after first reaching it, at least 0
  int excursions = 0;      ///< times beyond target + tolerance after reaching it
  Outcome<double> timeToTarget =
      Outcome<double>::undefined(Text::tr("the target was not reached"));  ///< first time within +- tolerance
  Outcome<double> settling =
      Outcome<double>::undefined(Text::tr("the angle did not settle"));  ///< start of the final stay
};
/// Measures how a target was reached. `target` must not be zero, `tolerance` > 0 (contract).
[[nodiscard]] TargetApproach targetApproach(std::span<const double> angle, double target, double tolerance,
                                            double rate_Hz);

struct TrackingError {
  double rmse = 0.0;
  double mae = 0.0;
  double bias = 0.0;  ///< mean of actual - target
  double largest = 0.0;
  Outcome<double> lag_s =
      Outcome<double>::undefined(Text::tr("the target does not move"));  ///< positive: actual follows
  Outcome<double> rmseWithoutLag = Outcome<double>::undefined(Text::tr("the target does not move"));
};
inline constexpr double kLargestLag_s = 0.5;
/// Compares the actual angle with the target at the same times. Undefined for empty signals.
[[nodiscard]] Outcome<TrackingError> trackingError(std::span<const double> actual,
                                                   std::span<const double> target, double rate_Hz);

/// Computes the standard deviation of the angle during a hold (divisor n - 1).
[[nodiscard]] Outcome<double> holdSteadiness(std::span<const double> heldAngle);
/// Returns the maximum rate at which the torque fell at release, positive; 0 if it never fell.
[[nodiscard]] Outcome<double> releaseRate(std::span<const double> releasedTorque, double rate_Hz);

}  // namespace torsio
