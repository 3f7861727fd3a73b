// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Finds the tip of a rounded end: the connected vertices about the organ's axis whose normals lie within
/// 30 degrees of it. The tip of a cut whose rim was smoothed is the whole cut, that of a dome reaches to
/// half the radius. The axis near the end runs through the centroids of two planar sections, found by
/// iteration from `seed`, any vertex of the end (its corner, mostly: that is the farthest from the other
/// end). `meanRadius_m` is where the search for the end's own radius begins. Empty when no such tip of a
/// sensible size is found.
[[nodiscard]] std::vector<std::uint32_t> roundedEnd(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                                    std::uint32_t seed, double meanRadius_m);

/// Part of the organ that a vertex of the mesh belongs to.
enum class LatticePart : std::uint8_t {
  kSide,      ///< between the end sections
  kFixedCap,  ///< at or beyond the fixed end: arc 0
  kFreeCap,   ///< at or beyond the free end: arc = length
};

/// Request for the ends of the organ; LatticeOptions says what the fields mean.
struct CapRequest {
  Vec3 fixedEnd_m;
  Vec3 freeEnd_m;
  Vec3 fixedCut;
  Vec3 freeCut;
  double capRadius_m = 0.0;

  /// Tells whether the caps are to be found: both end points are equal.
  [[nodiscard]] bool automatic() const noexcept { return fixedEnd_m == freeEnd_m; }
};

/// The two ends of the organ as sets of vertices: each connected, without holes, with no vertex in common, so
/// that what lies between them is a tube.
struct EndCaps {
  std::vector<LatticePart> parts;  ///< one a vertex
  Vec3 fixedCentre_m;
  Vec3 freeCentre_m;
  bool fixedFlat =
      false;  ///< the cap is a flat face: its rim is the organ's end, not a jagged line of vertices
  bool freeFlat = false;
};

/// Finds the two ends: flat faces where the organ has them, cuts where asked for, discs of the given
/// radius, else the rounded tips (roundedEnd). Throws Error{kBadMesh, kBadParameter}: caps that touch, a
/// cut beyond which nothing lies, an end not finite.
[[nodiscard]] EndCaps findEndCaps(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                  const CapRequest& request);

/// Tells whether `a` is below `b`: smaller z, then y, then x, each compared to a millionth of `scale_m`.
[[nodiscard]] bool isLower(const Vec3& a, const Vec3& b, double scale_m) noexcept;

/// Checks a request. Throws Error{kBadParameter} when an end point, cut or radius cannot be used.
void checkCapRequest(const CapRequest& request);

}  // namespace torsio
