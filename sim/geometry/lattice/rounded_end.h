// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

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

}  // namespace torsio
