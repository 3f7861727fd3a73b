// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/scene/tissue_look.h"

namespace torsio {

/// A short straight piece of a vessel on the organ at rest.
struct VesselPiece {
  Vec3 from_m;
  Vec3 to_m;
  float radius_m = 0.0F;
  float strength = 1.0F;  ///< 0 lost in the tissue .. 1 at the surface
};

/// Draws the vessels of a tissue: a main vessel along each border at which the organ hangs, and trees that
/// rise from it round the organ, fork and end before they meet. The same for the same organ on every run.
/// Milliseconds.
[[nodiscard]] std::vector<VesselPiece> growVessels(const TriangleMesh& mesh, const SectionLattice& lattice,
                                                   const TissueLook& look);

}  // namespace torsio
