// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// What was closed.
struct ClosedHoles {
  std::size_t count = 0;
  double widest_m = 0.0;  ///< largest side of the box of a hole's rim
};

/// Closes each hole of a welded surface by a fan about the middle of its rim: small gaps, and the flat ends
/// of a tube that was drawn without them; where rims meet in a vertex, each by itself. The faces along a rim
/// must agree in their orientation for it to be found.
[[nodiscard]] ClosedHoles closeHoles(TriangleMesh& mesh);

/// Returns the part of a welded surface where dot(normal, p) >= offset_m. A triangle that the plane crosses
/// is cut; both of two neighbours get the same new vertex, so that a closed surface is left with rims in the
/// plane and nothing else open. Vertices that nothing uses are gone. `normal` is a unit vector.
[[nodiscard]] TriangleMesh cutAt(const TriangleMesh& mesh, const Vec3& normal, double offset_m);

}  // namespace torsio
