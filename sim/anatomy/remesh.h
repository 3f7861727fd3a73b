// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sim/geometry/mesh/iso_surface.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Draws a closed manifold surface anew with triangles of nearly equal sides (Botsch and Kobbelt 2004: split
/// long edges, collapse short ones, turn edges to Delaunay, relax along the surface, project back).
/// `edgeLength` is the wanted edge length at a point; every vertex of the result lies on `mesh`. The topology
/// is kept. Deterministic: the same bits on every platform.
[[nodiscard]] TriangleMesh remeshed(const TriangleMesh& mesh,
                                    const std::function<double(const Vec3&)>& edgeLength);

/// The isoSurface() of a field, negative inside. `field` should grow by at most `slope` per unit of length:
/// regions further from the surface than that allows are skipped.
[[nodiscard]] TriangleMesh zeroSurface(const SampleGrid& grid, double slope,
                                       const std::function<double(const Vec3&)>& field);

}  // namespace torsio
