// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/base/vec3.h"
#include "sim/tissue/section/polygon.h"

namespace torsio {

/// Shape of the cells a bar is divided into.
enum class BarElement {
  kTetrahedron4,  ///< 4 points, linear displacement: what surgical simulators use
  kWedge6,        ///< triangle swept along the axis, 6 points: carries u = theta z (-y, x) exactly
};

/// How finely a bar is divided across and along its axis.
struct BarDivision {
  int rings = 2;    ///< rings of points between the axis and the outline, which is the last; >= 1
  int layers = 12;  ///< along the axis; >= 2
};

/// A bar of constant section as cells. Points run layer by layer from z = 0: first the one on the axis, then
/// ring by ring outwards, each ring a copy of the outline scaled by ring / rings.
struct BarMesh {
  std::vector<Vec3> points;               ///< metres
  std::vector<std::array<int, 6>> cells;  ///< wedge: triangle below, triangle above; tetrahedron: the first 4
  int cornersPerCell = 6;
  int pointsPerLayer = 0;
};

/// Extrudes `outline` (metres, anticlockwise, star-shaped about the axis at (0, 0)) along z. Each
/// quadrilateral between two rings is cut by diagonals that alternate from cell to cell, so that with an even
/// number of points every point of a regular polygon lies on a mirror line of its cells. A prism becomes
/// three tetrahedra by taking on each side face the diagonal through the point of lowest number. Throws
/// Error{kBadParameter}.
[[nodiscard]] BarMesh makeBarMesh(std::span<const Point2> outline, double length_m, BarElement element,
                                  const BarDivision& division);

}  // namespace torsio
