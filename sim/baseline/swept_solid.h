// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/lattice/section_lattice.h"

namespace torsio {

/// An organ between its two end sections as a grid of points: sections of equally many outline points, each
/// with a centre and rings of points between centre and outline. Straight or curved. What finite elements and
/// springs are made of; the outermost ring are the key points of the lattice.
struct SweptSolid {
  int ridges = 0;              ///< outline points of a section
  int sections = 0;            ///< along the organ, both ends included
  int rings = 0;               ///< of points round the centre; the last one is the outline
  std::vector<Vec3> points_m;  ///< number: see point()
  Vec3 endCentre_m;            ///< centre of the last section
  Vec3 endTangent;             ///< unit vector along the organ at its last section

  [[nodiscard]] const Vec3& centre_m(int section) const noexcept {
    return points_m[static_cast<std::size_t>(point(section, 0, 0))];
  }
  [[nodiscard]] int pointsPerSection() const noexcept { return 1 + ridges * rings; }
  /// Returns the number of a point: ring 0 is the centre of the section, whatever the ridge; ridges go round.
  [[nodiscard]] int point(int section, int ring, int ridge) const noexcept {
    return section * pointsPerSection() + (ring == 0 ? 0 : 1 + (ring - 1) * ridges + ridge % ridges);
  }
};

/// Builds the solid through outlines, one a section from the fixed to the free end, of equally many points
/// anticlockwise about the way from the fixed to the free end, metres. The centre of a section is the
/// centroid of its area. Throws Error{kBadParameter} for fewer than 3 points, 2 sections or 1 ring, more than
/// 200,000 points, and points that are not finite; Error{kBadMesh} that names the section when an outline is
/// not star-shaped about its centre, or the solid folds between two sections.
[[nodiscard]] SweptSolid sweptSolid(std::span<const std::vector<Vec3>> outlines_m, const Vec3& endTangent,
                                    int rings);

/// Builds the solid through the key points of a lattice. Throws as above.
[[nodiscard]] SweptSolid sweptSolid(const SectionLattice& lattice, int rings);

/// Returns the direction of the organ at a section, a unit vector: of the parabola through three neighbouring
/// centres (two in a solid of two sections); at the last section the one it was built with.
[[nodiscard]] Vec3 sectionTangent(const SweptSolid& solid, int section);
/// Returns the area within the outline of a section, m^2.
[[nodiscard]] double sectionArea_m2(const SweptSolid& solid, int section);

/// Elements of one kind: `nodesPerCell` numbers of points a cell, one cell after the other.
struct SolidMesh {
  int nodesPerCell = 4;
  std::vector<int> nodes;
  [[nodiscard]] std::size_t cells() const noexcept {
    return nodes.size() / static_cast<std::size_t>(nodesPerCell);
  }
  [[nodiscard]] std::span<const int> cell(std::size_t c) const noexcept {
    const auto count = static_cast<std::size_t>(nodesPerCell);
    return {nodes.data() + c * count, count};
  }
};

/// Divides the solid into linear tetrahedra: three a prism, with equal diagonals on the side that two prisms
/// share (they start at the point of lowest number). All have a positive volume.
[[nodiscard]] SolidMesh tetrahedra(const SweptSolid& solid);

/// Divides the solid into wedges of 6 corners: the lower triangle anticlockwise, then the upper one.
[[nodiscard]] SolidMesh linearWedges(const SweptSolid& solid);

/// Divides the solid into quadratic wedges of 18 nodes, each over two ridges, two rings and two sections.
/// Node a + 6 t: a = 0..2 corners, 3..5 middles of the sides 01, 12, 20 of the triangle; t = 0, 1, 2 lower,
/// middle, upper. Throws Error{kBadParameter} unless ridges, rings and steps between sections are even.
[[nodiscard]] SolidMesh quadraticWedges(const SweptSolid& solid);

/// Divides the solid into quadratic tetrahedra: three a quadratic wedge, on the same points. Corners 0..3,
/// then the middles of the sides 01, 02, 03, 12, 13, 23. Throws as quadraticWedges.
[[nodiscard]] SolidMesh quadraticTetrahedra(const SweptSolid& solid);
inline constexpr int kQuadraticTetrahedronNodes = 10;

/// Computes the volume of each tetrahedron, m^3.
[[nodiscard]] std::vector<double> tetrahedronVolumes(const SolidMesh& mesh, std::span<const Vec3> points_m);

}  // namespace torsio
