// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// What hangs on the side of an organ, as the oesophagus on the stomach.
struct SideBranch {
  Vec3 root_m;            ///< middle of its root, where it begins to open out into the organ
  Vec3 outward;           ///< unit, along it
  Vec3 away;              ///< unit, from the middle of the organ beside its root to that root
  double width_m = 0.0;   ///< diameter of the round section of the area at its root
  double length_m = 0.0;  ///< from its root to its tip
};

/// Finds the longest side branch of at most a tenth of the organ, for its width, away from the two named
/// ends: a piece as long as three quarters of its width that ends in a tip. None where there is no such.
/// `mesh`: closed and manifold. Some tenths of a second for 100 000 triangles.
[[nodiscard]] std::optional<SideBranch> findSideBranch(const TriangleMesh& mesh, const Vec3& fixedEnd_m,
                                                       const Vec3& freeEnd_m);

}  // namespace torsio
