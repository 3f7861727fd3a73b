// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A regular grid of sample points.
struct SampleGrid {
  Vec3 origin;
  double step = 1.0;
  std::array<std::size_t, 3> count{};  ///< points along x, y, z; at least 2 each
};

/// The surface on which `field` is zero, negative inside, with normals outwards: closed and manifold whatever
/// the field, as long as it is positive on the border of the grid. Each cube is cut into six tetrahedra about
/// its diagonal (Kuhn), so that neighbours agree on their faces. `field` should grow by at most `slope` per
/// unit of length: regions further from the surface than that allows are skipped.
[[nodiscard]] TriangleMesh zeroSurface(const SampleGrid& grid, double slope,
                                       const std::function<double(const Vec3&)>& field);

}  // namespace torsio
