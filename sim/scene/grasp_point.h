// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "sim/scene/scene.h"

namespace torsio {

/// A place on the organ's surface that an instrument reaches from outside.
struct GraspPoint {
  Vec3 point_m;
  Vec3 outwards;  ///< unit, away from the axis that the pattern turns about; the way along it is free
};

/// How far outside the surface a hand rests.
inline constexpr double kHandStartWay_m = 0.090;

/// Returns the arc length at which a pattern is gripped: an end section may lie within its cap, a hand grips
/// a little inside.
[[nodiscard]] double handGrasp_m(const Scene& scene) noexcept;

/// Returns where the section that the pattern grips is reached best, the organ at rest: it has a lever about
/// the axis, and nothing is in the way. None: no point of it can be reached.
[[nodiscard]] std::optional<GraspPoint> graspPoint(const Scene& scene);

}  // namespace torsio
