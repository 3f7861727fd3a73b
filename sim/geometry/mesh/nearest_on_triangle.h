// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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
