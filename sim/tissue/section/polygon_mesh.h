// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "sim/tissue/section/plane_mesh.h"

namespace torsio {

/// Triangulates any simple outline (anticlockwise) with holes (clockwise) inside it by Delaunay's rule.
/// Boundary edges stay as they are; points are added inside until the triangles are well shaped. Returns
/// none when rounding leaves no ear to cut, which happens only when edges all but touch.
[[nodiscard]] std::optional<PlaneMesh> polygonMesh(const BoundaryLoop& outline,
                                                   std::span<const BoundaryLoop> holes);

}  // namespace torsio
