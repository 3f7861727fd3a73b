// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Thins a closed manifold surface to about `most` triangles (at least 200) by collapsing edges, those first
/// whose loss changes the shape least (quadric error, Garland and Heckbert 1997; among equals the shorter, so
/// that triangles stay even). Vertices move to where the error is least. The topology stays, no triangle
/// turns over; more are left than asked for where the shape allows no fewer. Some seconds for a million
/// triangles. Deterministic: the same bits on every platform.
[[nodiscard]] TriangleMesh thinned(TriangleMesh mesh, std::size_t most);

/// Smooths a closed surface without shrinking it (Taubin 1995: each pass draws every vertex towards the mean
/// of its neighbours by 0.5 and then pushes it away by 0.53). Stair steps go, the volume stays within some
/// hundredths of a per cent. Indices must be in range.
void smooth(TriangleMesh& mesh, int passes);

}  // namespace torsio
