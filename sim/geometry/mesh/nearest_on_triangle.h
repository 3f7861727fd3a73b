// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

#include "sim/core/vec3.h"

namespace torsio {

struct TriangleCorners {
  Vec3 a, b, c;
};

/// Closest point of one triangle, with the feature on which it lies.
struct NearestOnTriangle {
  double distance2 = std::numeric_limits<double>::infinity();
  Vec3 point;
  double u = 1.0, v = 0.0, w = 0.0;  ///< barycentric, of the corners a, b, c
  std::uint8_t feature = 0;          ///< 0..2 corner, 3..5 the edge that starts at corner 0..2, 6 the face
};

/// Finds the closest point of a triangle by Voronoi regions (Ericson, Real-Time Collision Detection, 2005,
/// section 5.1.5). A triangle without area may give NaN, which is never nearer than a neighbour.
/// Allocation-free.
[[nodiscard]] inline NearestOnTriangle nearestOnTriangle(const Vec3& p, const TriangleCorners& t) noexcept {
  const auto at = [&p](const Vec3& point, double u, double v, double w, std::uint8_t feature) {
    const Vec3 d = p - point;
    return NearestOnTriangle{dot(d, d), point, u, v, w, feature};
  };
  const Vec3 ab = t.b - t.a;
  const Vec3 ac = t.c - t.a;
  const Vec3 ap = p - t.a;
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return at(t.a, 1.0, 0.0, 0.0, 0);
  }
  const Vec3 bp = p - t.b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) {
    return at(t.b, 0.0, 1.0, 0.0, 1);
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return at(t.a + v * ab, 1.0 - v, v, 0.0, 3);
  }
  const Vec3 cp = p - t.c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) {
    return at(t.c, 0.0, 0.0, 1.0, 2);
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return at(t.a + w * ac, 1.0 - w, 0.0, w, 5);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(t.b + w * (t.c - t.b), 0.0, 1.0 - w, w, 4);
  }
  const double sum = va + vb + vc;
  const double v = vb / sum;
  const double w = vc / sum;
  return at(t.a + v * ab + w * ac, va / sum, v, w, 6);
}

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
