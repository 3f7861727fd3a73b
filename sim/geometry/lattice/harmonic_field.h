// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/geometry/lattice/end_caps.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// The two coordinates of the organ's side, one value a vertex: the level u, 0 on the fixed and 1 on the free
/// cap, and the harmonic angle about the organ, known up to whole turns. Both solve the discrete Laplace
/// equation with cotangent weights, clamped to be positive: then each value is a mean of its neighbours, u
/// has no extremum between the caps, and on a sphere without two discs (Euler number 0) every level is one
/// loop.
struct HarmonicField {
  std::vector<double> level;      ///< u
  std::vector<double> angle_rad;  ///< means nothing inside the caps, away from their rims
  /// Whole turns, one number a half-edge: the angle rises by angle(target) - angle(origin) + 2 pi turns
  /// along it.
  std::vector<std::int8_t> turns;

  /// Returns the rise of the angle along a half-edge.
  [[nodiscard]] double rise_rad(const SurfaceTopology& topology, std::uint32_t half) const noexcept;
};

/// Tells whether the triangle lies between the caps: its corners do not all belong to the same one.
[[nodiscard]] bool isSideTriangle(const TriangleMesh::Triangle& triangle, std::span<const LatticePart> parts);

/// Solves for both coordinates. With `level` given (one a vertex, from the straight axis) only the angle is
/// solved for. Throws Error{kBadMesh} when the surface between the caps is not a tube.
[[nodiscard]] HarmonicField solveHarmonicField(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                               std::span<const LatticePart> parts,
                                               std::vector<double> level = {});

}  // namespace torsio
