// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/vec3.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Where a vertex of the mesh belongs.
enum class LatticePart : std::uint8_t {
  kSide,      ///< between the end sections
  kFixedCap,  ///< at or beyond the fixed end: arc 0
  kFreeCap,   ///< at or beyond the free end: arc = length
};

/// How an end of the organ was asked for. See LatticeOptions for the meaning.
struct CapRequest {
  Vec3 fixedEnd_m;
  Vec3 freeEnd_m;
  Vec3 fixedCut;
  Vec3 freeCut;
  double capRadius_m = 0.0;

  /// Both end points equal: the caps are to be found.
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

/// Flat faces where the organ has them at its ends, cuts where asked for, discs of the given radius, else the
/// rounded tips (roundedEnd). Throws
/// Error{kBadMesh, kBadParameter}: caps that touch, a cut beyond which nothing lies, an end not finite.
[[nodiscard]] EndCaps findEndCaps(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                  const CapRequest& request);

/// True when `a` is below `b`: smaller z, then y, then x, each compared to a millionth of `scale_m`.
[[nodiscard]] bool isLower(const Vec3& a, const Vec3& b, double scale_m) noexcept;

/// Throws Error{kBadParameter} when an end point, cut or radius cannot be used.
void checkCapRequest(const CapRequest& request);

}  // namespace torsio
