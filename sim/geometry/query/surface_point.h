// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/vec3.h"

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

}  // namespace torsio
