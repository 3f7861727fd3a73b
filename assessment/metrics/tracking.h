// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "assessment/statistics/values.h"

namespace torsio {

/// How a target angle was reached and kept. All angles in one unit, times in seconds from the first sample.
struct TargetApproach {
  double overshoot = 0.0;  ///< beyond the target after first reaching it, at least 0
  int excursions = 0;      ///< times beyond target + tolerance after reaching it
  Outcome<double> timeToTarget =
      Outcome<double>::undefined(Text::tr("the target was not reached"));  ///< first inside +- tolerance
  Outcome<double> settling =
      Outcome<double>::undefined(Text::tr("the angle did not settle"));  ///< start of the last stay
};
/// Measures how a target was reached. `target` not zero, `tolerance` > 0 (contract).
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
/// Compares the actual angle with the target on the same clock. Undefined for empty signals.
[[nodiscard]] Outcome<TrackingError> trackingError(std::span<const double> actual,
                                                   std::span<const double> target, double rate_Hz);

/// Computes the standard deviation of the angle while it should be held still (divisor n - 1).
[[nodiscard]] Outcome<double> holdSteadiness(std::span<const double> heldAngle);
/// Returns the largest rate at which the torque was let go, as a positive number; 0 when it never fell.
[[nodiscard]] Outcome<double> releaseRate(std::span<const double> releasedTorque, double rate_Hz);

}  // namespace torsio
