// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/lattice/centreline.h"
#include "sim/geometry/lattice/level_loops.h"
#include "sim/geometry/lattice/section_lattice.h"

namespace torsio {

/// How a loop is divided into ridges.
struct RidgeRule {
  RidgeSpacing spacing = RidgeSpacing::kArcLength;
  /// With kArcLength, true: ridge 0 leaves the centre along the frame's e1 (as with kAngle); false: ridge 0
  /// follows the harmonic angle anchor_rad.
  bool alongE1 = false;
  double anchor_rad = 0.0;
};

/// One section in its frame.
struct SectionOutline {
  std::vector<Point2> points_m;
  std::vector<double> angles_rad;
  std::vector<Vec3> ridges_m;  ///< the key points, on the mesh
};

/// Returns the place (x, y) of a point along e1, e2 of the frame.
[[nodiscard]] Point2 inFrame(const AxisFrame& frame, const Vec3& point_m) noexcept;

/// Tells whether the polar angle about the frame's centre rises all the way round the loop.
[[nodiscard]] bool isStarShaped(const LevelLoop& loop, const AxisFrame& frame);

/// Cuts outline and key points out of a loop. `name` names the section in errors. Throws Error{kBadMesh}:
/// an outline without area or one that crosses itself.
[[nodiscard]] SectionOutline cutOutline(const LevelLoop& loop, const AxisFrame& frame, const RidgeRule& rule,
                                        int ridges, const std::string& name);

/// Returns the point of a loop with the given ridge angle.
[[nodiscard]] LatticePoint pointOnLoop(const LevelLoop& loop, const AxisFrame& frame, const RidgeRule& rule,
                                       double angle_rad, const TriangleMesh& mesh);

/// Returns the way along the loop, as a share of its perimeter, from where the harmonic angle passes 0 to
/// where it passes 2 pi k / count, for k = 0..count: from 0 to 1, never decreasing.
[[nodiscard]] std::vector<double> wayAtAngles(const LevelLoop& loop, int count);

/// Place at which the ray from the frame's centre along e1 leaves the loop.
struct RayExit {
  double way_m = 0.0;      ///< along the loop
  double angle_rad = 0.0;  ///< harmonic angle
};
[[nodiscard]] RayExit exitAlongE1(const LevelLoop& loop, const AxisFrame& frame);

/// Returns the way along the loop from where the harmonic angle passes 0 to `way_m`, as a share of its
/// perimeter.
[[nodiscard]] double shareOfWay(const LevelLoop& loop, double way_m);

/// Returns the ridge angle at which the ray from the centre towards (x, y) leaves the outline; 0 for the
/// centre.
[[nodiscard]] double ridgeAngleTowards(const SectionOutline& outline, const Point2& direction);

}  // namespace torsio
