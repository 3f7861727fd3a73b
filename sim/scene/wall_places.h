// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "sim/tissue/section/wall_section.h"

namespace torsio {

/// Computes the wall of an organ at 41 equal steps of its axis, from one arc length to another (either way):
/// the radius of the middle line of the wall, from the organ's outlines. Throws Error{kBadMesh,
/// kBadParameter} as SectionLattice::outlinesAt and wallSection. Allocates, not for the tick.
[[nodiscard]] std::vector<WallPlace> wallPlaces(const SectionLattice& lattice, const WallMap& wall,
                                                double from_m, double to_m);

}  // namespace torsio
