// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "sim/tissue/section/wall_section.h"

namespace torsio {

struct WallRay;

/// Thickness of the wall of an organ over the patches of its lattice: that between sections j, j + 1 and
/// ridges k, k + 1 at [j * ridges + k].
struct OrganWallMap {
  int bands = 0;                    ///< of the length: sections - 1
  int ridges = 0;                   ///< sectors of the turn
  std::vector<double> thickness_m;  ///< bands * ridges
  std::vector<std::uint8_t> seen;   ///< 0: filled in from the patches around
  [[nodiscard]] std::size_t seenPatches() const noexcept;
  friend bool operator==(const OrganWallMap&, const OrganWallMap&) = default;
};

/// Draws the map of a wall: the median of the rays that start over a patch; patches without one take the
/// mean of those around them, on and on. None where fewer than a fifth of the patches have one. `mesh`: of
/// `lattice`; nowhere thicker than 0.4 of the radius of the section.
[[nodiscard]] std::optional<OrganWallMap> wallMapOf(std::span<const WallRay> rays, const TriangleMesh& mesh,
                                                    const SectionLattice& lattice);

/// Returns the thickness along an organ, as HollowWall has it: pairs of a share of the length and the
/// thickness that carries the same shear round the section (Bredt): the harmonic mean of its patches.
[[nodiscard]] std::vector<std::array<double, 2>> thicknessAlong_m(const OrganWallMap& map);

/// Computes the wall of an organ at 41 equal steps of its axis, from one arc length to another (either way):
/// the radius of the middle line of the wall, from the organ's outlines. Throws Error{kBadMesh,
/// kBadParameter} as SectionLattice::outlinesAt and wallSection. Allocates, not for the tick.
[[nodiscard]] std::vector<WallPlace> wallPlaces(const SectionLattice& lattice, const WallMap& wall,
                                                double from_m, double to_m);

}  // namespace torsio
