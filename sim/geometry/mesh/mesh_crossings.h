// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Two triangles of a mesh by their indices, the smaller first.
using TrianglePair = std::pair<std::uint32_t, std::uint32_t>;

/// Finds the pairs of triangles that cut through one another, ascending. Triangles that share a corner are
/// not compared, and touching is not cutting. O(T log T) for a surface that hardly crosses itself. Any mesh
/// with finite vertices and valid indices.
[[nodiscard]] std::vector<TrianglePair> crossingTriangles(const TriangleMesh& mesh);

}  // namespace torsio
