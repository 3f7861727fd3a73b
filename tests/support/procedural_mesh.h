// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::testing {

/// A simple polygon, anticlockwise, first point not repeated. Metres.
using Outline2 = std::vector<std::array<double, 2>>;

[[nodiscard]] Outline2 ellipseOutline(double a_m, double b_m, int points);
[[nodiscard]] inline Outline2 circleOutline(double radius_m, int points) {
  return ellipseOutline(radius_m, radius_m, points);
}
/// Centred, sides parallel to x and y, `perSide` equal steps per side, starting at a corner.
[[nodiscard]] Outline2 rectangleOutline(double width_m, double height_m, int perSide);
/// Star with `tips` tips: radius outer_m at the tips, inner_m between them.
[[nodiscard]] Outline2 starOutline(int tips, double outer_m, double inner_m);
/// Thick letter C of mean radius `radius_m`, `width_m` wide, open by 90 degrees towards +x: its centroid is
/// outside, so that it is star-shaped about no point.
[[nodiscard]] Outline2 letterC(double radius_m, double width_m, int points);

[[nodiscard]] double areaOf(const Outline2& outline);
[[nodiscard]] std::array<double, 2> centroidOf(const Outline2& outline);

/// Position of a section of a swept bar.
struct SweepFrame {
  Vec3 centre_m;
  Vec3 e1{1, 0, 0};
  Vec3 e2{0, 1, 0};
  double scale = 1.0;
};

/// A closed bar: `rings` + 1 copies of the outline, placed by frameAt(0..1), joined by triangles and closed
/// by flat ends. `alternate`: the diagonals change sides from ring to ring.
[[nodiscard]] TriangleMesh sweep(const Outline2& outline, int rings,
                                 const std::function<SweepFrame(double)>& frameAt, bool alternate = false);

/// Upright bar from z = 0 to z = height; `topScale` shrinks the outline linearly towards the top.
[[nodiscard]] TriangleMesh prism(const Outline2& outline, double height_m, int rings, double topScale = 1.0);
/// Round tube whose axis is an arc of `angle_rad` and radius `bend_m` in the x-z plane, from the origin up.
[[nodiscard]] TriangleMesh bentTube(double radius_m, double bend_m, double angle_rad, int points, int rings);
/// Straight up by `straight_m`, then a half circle of radius `bend_m` and a third of the way back down.
[[nodiscard]] TriangleMesh jTube(double radius_m, double straight_m, double bend_m, int points, int rings);
/// Two straight legs of `leg_m` that meet at a sharp angle: `turn_rad` is the change of direction.
[[nodiscard]] TriangleMesh kinkedTube(double radius_m, double leg_m, double turn_rad, int points, int rings);
/// Round bar with hemispherical ends, from z = -radius to length + radius.
[[nodiscard]] TriangleMesh capsule(double radius_m, double length_m, int points, int rings);

[[nodiscard]] TriangleMesh turned(TriangleMesh mesh, const Vec3& axis, double angle_rad);
[[nodiscard]] TriangleMesh shifted(TriangleMesh mesh, const Vec3& by_m);
[[nodiscard]] TriangleMesh mirroredX(TriangleMesh mesh);
/// Both surfaces in one mesh, the second moved by `offset_m`.
[[nodiscard]] TriangleMesh together(TriangleMesh first, const TriangleMesh& second,
                                    const Vec3& offset_m = {});

}  // namespace torsio::testing
