// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"

namespace torsio {

/// In place of the index of a triangle: none is known.
inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFU;

/// Closest point of the organ's surface to a query point. Metres.
struct SurfacePoint {
  Vec3 position_m;
  Vec3 normal;              ///< unit, outwards (angle-weighted pseudonormal)
  double distance_m = 0.0;  ///< signed: negative inside the organ
  std::uint32_t triangle = 0;
  double barycentric[3] = {1.0, 0.0, 0.0};  ///< of the triangle's corners
};

/// Closest pair of the organ's surface and a segment.
struct SegmentHit {
  bool found = false;    ///< within the reach that was asked for
  double along = 0.0;    ///< the segment's point, 0..1
  SurfacePoint surface;  ///< nearest to that point; distance 0 where the segment pierces the surface
};

/// Closest pair of a segment and one triangle.
struct NearestToSegment {
  NearestOnTriangle on;  ///< the triangle's point; distance2 is exactly 0 where the segment pierces it
  double along = 0.0;    ///< the segment's point, 0..1
};

/// Squared distance below which the segment counts as piercing: rounding of coordinates of 0.1 m.
inline constexpr double kPierced_m2 = 1e-24;

/// Returns where along `segment` the point nearest to the edge a-b lies (Ericson, Real-Time Collision
/// Detection, 2005, section 5.1.9); the segment has a length.
[[nodiscard]] inline double alongNearestToEdge(const Segment& segment, const Vec3& a,
                                               const Vec3& b) noexcept {
  const Vec3 d1 = segment.to_m - segment.from_m;
  const Vec3 d2 = b - a;
  const Vec3 r = segment.from_m - a;
  const double d11 = dot(d1, d1);
  const double d22 = dot(d2, d2);
  const double d12 = dot(d1, d2);
  const double c = dot(d1, r);
  const double f = dot(d2, r);
  const double denominator = d11 * d22 - d12 * d12;
  double s = denominator > 0.0 ? std::clamp((d12 * f - c * d22) / denominator, 0.0, 1.0) : 0.0;
  const double t = d12 * s + f;
  if (t < 0.0) {
    s = std::clamp(-c / d11, 0.0, 1.0);
  } else if (t > d22) {
    s = std::clamp((d12 - c) / d11, 0.0, 1.0);
  }
  return s;
}

/// Finds the closest pair of a segment and a triangle. The pair lies at an end of the segment, where the
/// segment passes an edge, or where it pierces the plane: the best of those is exact. Allocation-free, IEEE
/// basic operations in a fixed order.
[[nodiscard]] inline NearestToSegment nearestToSegment(const Segment& segment,
                                                       const TriangleCorners& t) noexcept {
  NearestToSegment best;
  const auto look = [&](double along) {
    const NearestOnTriangle n = nearestOnTriangle(segment.at(along), t);
    if (n.distance2 < best.on.distance2) {
      best = {n, along};
    }
  };
  look(0.0);
  if (segment.from_m == segment.to_m) {
    return best;
  }
  look(1.0);
  const Vec3 normal = cross(t.b - t.a, t.c - t.a);
  const double before = dot(normal, segment.from_m - t.a);
  const double behind = dot(normal, segment.to_m - t.a);
  if ((before < 0.0) != (behind < 0.0)) {
    look(std::clamp(before / (before - behind), 0.0, 1.0));
    if (best.on.distance2 <= kPierced_m2) {
      best.on.distance2 = 0.0;
      return best;
    }
  }
  look(alongNearestToEdge(segment, t.a, t.b));
  look(alongNearestToEdge(segment, t.b, t.c));
  look(alongNearestToEdge(segment, t.c, t.a));
  if (best.on.distance2 <= kPierced_m2) {
    best.on.distance2 = 0.0;
  }
  return best;
}

}  // namespace torsio
