// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/vec3.h"

namespace torsio {

/// A straight piece of an instrument: the axis of a capsule. Both ends may be the same point.
struct Segment {
  Vec3 from_m;
  Vec3 to_m;

  /// Returns the point at the fraction `along` of the way, 0..1.
  [[nodiscard]] constexpr Vec3 at(double along) const noexcept { return from_m + (to_m - from_m) * along; }
};

/// Returns the fraction along the segment of the place nearest to a point, 0..1; 0 when both ends are the
/// same.
[[nodiscard]] constexpr double nearestAlong(const Segment& segment, const Vec3& point_m) noexcept {
  const Vec3 way = segment.to_m - segment.from_m;
  const double length2 = dot(way, way);
  if (!(length2 > 0.0)) {
    return 0.0;
  }
  const double along = dot(point_m - segment.from_m, way) / length2;
  return along < 0.0 ? 0.0 : (along > 1.0 ? 1.0 : along);
}

}  // namespace torsio
