// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Thins a closed manifold surface to about `most` triangles (at least 200) by collapsing its shortest edges
/// first, pass by pass; every vertex that is left lies where it was, and the topology stays. Fewer passes
/// than it would take where the shape allows no more. For looking at a shape, not for keeping it: detail
/// below the new edge length goes. About a second for a million triangles.
[[nodiscard]] TriangleMesh thinned(TriangleMesh mesh, std::size_t most);

}  // namespace torsio
