// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/geometry/lattice/section_lattice.h"

namespace torsio {

/// Arc length of any point near an organ at rest, such that on the surface it agrees with the lattice's own
/// coordinates. On a curved organ the sections of the lattice are not planes: what a tool touches would lie
/// some millimetres beside what a view draws if the arc length of a free point were simply that of the
/// nearest point of the centreline. The difference is tabled over (nearest arc length, polar angle) and fades
/// towards the axis. Straight lattices: sections are planes, the height itself. Immutable; the query is
/// noexcept, allocation-free, portable arithmetic only.
class ArcField {
 public:
  ArcField() = default;
  ArcField(const TriangleMesh& mesh, const SectionLattice& lattice);

  [[nodiscard]] double arcAt(const SectionLattice& lattice, const Vec3& point_m) const noexcept;

 private:
  struct Node {
    double shift_m = 0.0;   // lattice arc length minus nearest arc length, on the surface
    double radius_m = 0.0;  // distance of the surface from the centreline
  };
  struct Place {  // four nodes round a point, and where it lies between them
    std::size_t node[4] = {};
    double weight[4] = {};
  };
  [[nodiscard]] Place placeOf(double arc_m, double polar_rad) const noexcept;
  void fillGaps(std::vector<Node> sums, std::vector<double> weights);

  double length_m_ = 0.0;
  std::vector<Node> nodes_;  // [arc][angle]; empty: no shift
};

}  // namespace torsio
