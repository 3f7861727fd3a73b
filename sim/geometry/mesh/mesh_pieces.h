// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/geometry/mesh/mesh_repair.h"

namespace torsio {

/// Returns for each triangle the index of its connected piece (through shared vertices), numbered from 0 in
/// the order of their first triangle.
[[nodiscard]] std::vector<std::uint32_t> componentOfTriangles(const TriangleMesh& mesh);

/// Drops separate pieces: those inside the largest, and the rest when together they have at most
/// `smallShare` of the area. Returns the share of the area that lies in pieces too large to drop, 0 when
/// one piece is left.
[[nodiscard]] double keepMainComponent(TriangleMesh& mesh, double smallShare, MeshRepairs& repairs);

}  // namespace torsio
