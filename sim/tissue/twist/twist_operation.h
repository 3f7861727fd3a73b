// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "sim/base/vec3.h"

namespace torsio {

/// Axis that one operation turns the organ about.
enum class TwistAxis {
  kCentreline,  ///< the organ's own axis: every section turns in its own plane
  kStraight,    ///< a straight line in space through two anatomical landmarks
};

/// Coordinate that the angle of a straight-axis operation depends on.
enum class TwistCoordinate {
  kAlongAxis,  ///< the way along the axis: every volume is kept exactly (det F = 1)
  kArc,        ///< the organ's own arc length, as at a hinge: det F is reported, not 1
};

/// How the angle is spread over the fraction x in [from, to]; 1 at the peak, 0 where held.
enum class TwistProfile {
  kElastic,     ///< as the torsional compliance of the organ says, with the end conditions of the model
  kRamp,        ///< 0 at `from`, straight up to the peak, rigid beyond it
  kTent,        ///< 0 at `from`, straight up to the peak and down to 0 at `to`
  kSmoothRamp,  ///< like kRamp with 3 t^2 - 2 t^3: no kink
  kSmoothTent,  ///< like kTent with 3 t^2 - 2 t^3: no kink
};

/// One twist of a pattern. A pattern is an ordered list: the first acts on the organ at rest, each later one
/// on what the earlier ones made of it. Finite rotations are composed; displacements are never added.
struct TwistOperation {
  TwistAxis axis = TwistAxis::kCentreline;
  Vec3 axisFrom_m;  ///< kStraight: the axis starts here (fraction 0), world frame, organ at rest
  Vec3 axisTo_m;    ///< kStraight: and runs through here (fraction 1)
  TwistCoordinate coordinate = TwistCoordinate::kAlongAxis;  ///< kStraight only
  TwistProfile profile = TwistProfile::kElastic;
  /// Place up to which the organ is held. Fraction of the organ's length from its fixed end (kCentreline,
  /// kArc) or of the way axisFrom -> axisTo (kAlongAxis; may leave 0..1).
  double from = 0.0;
  double to = 1.0;             ///< the other end of the twisted part, > from
  std::optional<double> peak;  ///< where the full angle is reached, in (from, to]; none: at the grasp
  double ratio = 1.0;  ///< angle at the peak as a multiple of the grasp angle; < 0: the other way round
};

inline constexpr int kMostOperations = 8;

/// Returns the share of the full angle at fraction `x` for every profile but kElastic; `peak` in (from,
/// to].
[[nodiscard]] double profileShare(const TwistOperation& operation, double x, double peak) noexcept;
/// Returns d profileShare / dx.
[[nodiscard]] double profileSlope(const TwistOperation& operation, double x, double peak) noexcept;

/// Checks the operations of a pattern. Throws Error{kBadParameter} naming the operation (counted from 1),
/// the value and the limit: not finite, axis points closer than 1 mm, to <= from, peak outside (from, to],
/// arc fractions outside 0..1, ratio 0.
void checkOperations(std::span<const TwistOperation> operations);

}  // namespace torsio
