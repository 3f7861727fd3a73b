// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A regular grid of sample points.
struct SampleGrid {
  Vec3 origin;
  double step = 1.0;
  std::array<std::size_t, 3> count{};  ///< points along x, y, z; at least 2 each
};

/// Writes the samples of layer z of a grid, x fastest. Called once for each layer, upwards.
using LayerOfSamples = std::function<void(std::size_t z, std::span<double> layer)>;

/// The surface on which the samples are zero, negative inside, with normals outwards: closed and manifold
/// whatever the samples, as long as they are positive on the border of the grid. Each cube is cut into six
/// tetrahedra about its diagonal (Kuhn), so that neighbours agree on their faces. Two layers are in memory at
/// a time. Deterministic: the same bits on every platform.
[[nodiscard]] TriangleMesh isoSurface(const SampleGrid& grid, const LayerOfSamples& layerAt);

}  // namespace torsio
