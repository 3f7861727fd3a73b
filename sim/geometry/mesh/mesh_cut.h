// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Returns the part of a welded surface where dot(normal, p) >= offset_m. A triangle that the plane crosses
/// is cut; both of two neighbours get the same new vertex, so that a closed surface is left with rims in the
/// plane and nothing else open. Vertices that nothing uses are gone. `normal` is a unit vector.
[[nodiscard]] TriangleMesh cutAt(const TriangleMesh& mesh, const Vec3& normal, double offset_m);

}  // namespace torsio
