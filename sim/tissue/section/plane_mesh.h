// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/tissue/section/polygon.h"

namespace torsio {

/// One closed boundary of a section as the meshers need it: points in order with the material on the left
/// (outline anticlockwise, hole clockwise) and the way along the loop of each.
struct BoundaryLoop {
  std::vector<Point2> points;
  std::vector<double> arc;  ///< 0 at the first point, strictly increasing
  double length = 0.0;      ///< the way once round
};

/// A conforming triangulation of a section. Corner k of a triangle faces its neighbour k.
struct PlaneMesh {
  std::vector<Point2> points;
  std::vector<std::array<int, 3>> triangles;   ///< anticlockwise
  std::vector<std::array<int, 3>> neighbours;  ///< -1 at the boundary
  std::vector<int> loop;                       ///< per point: -1 inside, 0 outline, k hole k
  std::vector<double> arc;                     ///< per point: way along its loop; 0 inside
  std::vector<double> loopLength;              ///< per loop
};

/// Appends the points of a loop; returns the index of the first point. Loops are added in this order:
/// outline, holes.
int addLoop(PlaneMesh& mesh, const BoundaryLoop& boundary);

/// Makes `now` the neighbour of triangle `t` where `old` was; none for t = -1, outside the boundary.
void relink(PlaneMesh& mesh, int t, int old, int now);

/// Fills `neighbours` from `triangles`.
void linkNeighbours(PlaneMesh& mesh);

/// Returns the way along the loop halfway between two neighbouring boundary points.
[[nodiscard]] double middleArc(const PlaneMesh& mesh, int a, int b);

/// Splits each marked triangle (and those that conformity asks for) through the middle of its longest edge
/// (Rivara): the smallest angle stays above half of its first value, the polygon does not change.
void bisect(PlaneMesh& mesh, std::span<const char> marked);

/// Meshes a section by rings of the outline, shrunk towards `centre` and closer together outside, with
/// every second ray left out from ring to ring where the cells would otherwise be longer along the ray than
/// across. `outline` must be star-shaped about `centre`.
[[nodiscard]] PlaneMesh polarMesh(const BoundaryLoop& outline, const Point2& centre, int rings);

/// Triangulates any simple outline (anticlockwise) with holes (clockwise) inside it by Delaunay's rule.
/// Boundary edges stay as they are; points are added inside until the triangles are well shaped. Returns
/// none when rounding leaves no ear to cut, which happens only when edges all but touch.
[[nodiscard]] std::optional<PlaneMesh> polygonMesh(const BoundaryLoop& outline,
                                                   std::span<const BoundaryLoop> holes);

}  // namespace torsio
