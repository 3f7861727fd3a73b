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

}  // namespace torsio
