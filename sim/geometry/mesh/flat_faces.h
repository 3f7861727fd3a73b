// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A connected flat piece of the surface with a sharp rim: where an organ was cut, or the end of a bar.
struct FlatFace {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> vertices;  ///< without repetition
  Vec3 centroid_m;                      ///< of the area
  Vec3 normal;                          ///< unit, outwards
  double area_m2 = 0.0;
};

/// Finds all flat faces with at least a thousandth of the surface's area, largest first. "Flat" allows for
/// coordinates rounded to a hundred-thousandth of the organ's size.
[[nodiscard]] std::vector<FlatFace> findFlatFaces(const TriangleMesh& mesh, const SurfaceTopology& topology);

/// Returns the index of the triangle nearest to a point.
[[nodiscard]] std::uint32_t nearestTriangle(const TriangleMesh& mesh, const Vec3& point_m);

}  // namespace torsio
