// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sim/core/vec3.h"

namespace torsio {

/// A cone with a ball at each end.
struct RoundCone {
  Vec3 a, b;
  double radiusA = 0.0;
  double radiusB = 0.0;
};

/// From a point to the skin of a cone, about; negative inside.
[[nodiscard]] double distanceTo(const RoundCone& cone, const Vec3& p);

/// Union of two bodies by their distances, rounded where they are nearer than `width` to each other.
[[nodiscard]] double joined(double a, double b, double width);

/// The union of many, rounded by `width` from one to the next.
[[nodiscard]] double joinedChain(std::span<const RoundCone> cones, const Vec3& p, double width);

}  // namespace torsio
