// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/tissue/section/plane_mesh.h"

namespace torsio {

/// Meshes a section by rings of the outline, shrunk towards `centre` and closer together outside, with
/// every second ray left out from ring to ring where the cells would otherwise be longer along the ray than
/// across. `outline` must be star-shaped about `centre`.
[[nodiscard]] PlaneMesh polarMesh(const BoundaryLoop& outline, const Point2& centre, int rings);

}  // namespace torsio
