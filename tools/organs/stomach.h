// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/base/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A tube-like organ with the points at which a twist holds it. Metres, LPS.
struct TubeOrgan {
  TriangleMesh surface;
  Vec3 fixedEnd_m;
  Vec3 freeEnd_m;
  Vec3 ridgeZero;  ///< direction from the axis in which ridge 0 lies
};

/// The default J-shaped stomach: pylorus fixed, fundus free, ridge 0 on the lesser curvature. Centreline
/// 267 mm, about 710 ml; about ten thousand triangles.
[[nodiscard]] TubeOrgan makeStomach();

/// A loop of small intestine, 200 mm long and about 27 mm wide, with gentle waves.
[[nodiscard]] TubeOrgan makeIntestine();

}  // namespace torsio
