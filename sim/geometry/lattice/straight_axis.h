// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/lattice/end_caps.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// The part of an organ that is cut by parallel planes (paper section 3.1).
struct StraightAxis {
  Vec3 origin_m;                         ///< on the plane of the fixed end
  Vec3 direction;                        ///< unit, from the fixed to the free end
  double length_m = 0.0;                 ///< distance of the end planes
  std::vector<std::uint32_t> fixedFace;  ///< vertices of the flat fixed end, none when it is rounded
  std::vector<std::uint32_t> freeFace;   ///< vertices of the flat free end, none when it is rounded

  /// Returns the height above the plane of the fixed end as a share of the length.
  [[nodiscard]] double level(const Vec3& point_m) const noexcept {
    return dot(point_m - origin_m, direction) / length_m;
  }
};

/// Finds the axis through the given end points, or the principal axis of the surface (weighted by area).
/// Where the organ has flat ends across it, the planes are parallel to them and begin and end with them;
/// rounded ends are left out by up to a fiftieth of the length, because a plane that touches a dome cuts
/// nothing. Throws Error{kBadMesh} when no direction is the longest by a fifth.
[[nodiscard]] StraightAxis findStraightAxis(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                            const CapRequest& request);

/// Tells whether the organ is a bar: two parallel flat ends across it, and every plane between them cuts
/// one loop whose centroid stays within a hundredth of the length from the axis.
[[nodiscard]] bool isStraightBar(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                 const CapRequest& request);

/// Returns the axis's level at every vertex; vertices of a flat end, and those on an end plane up to
/// rounding, get exactly its level.
[[nodiscard]] std::vector<double> axisLevels(const TriangleMesh& mesh, const StraightAxis& axis);

}  // namespace torsio
