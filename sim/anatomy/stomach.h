// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "sim/anatomy/organ_places.h"
#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A tube-like organ with the points at which a twist holds it. Metres, LPS.
struct TubeOrgan {
  TriangleMesh surface;
  Vec3 fixedEnd_m;
  Vec3 freeEnd_m;
  Vec3 ridgeZero;  ///< direction from the axis in which ridge 0 lies
  /// Of each vertex: share of the length along the organ, and of a turn about it from ridge 0; both 0..1. The
  /// second jumps from 1 to 0 at ridge 0: unwrap it within a triangle.
  std::vector<std::array<float, 2>> texture;
  double length_mm = 0.0;  ///< of the centreline
  OrganPlaces places;      ///< of the stomach: in WholeStomach
};

/// A J-shaped stomach without oesophagus: pylorus fixed, fundus free, ridge 0 on the lesser curvature.
/// Centreline 267 mm, about 710 ml; about ten thousand triangles. Older recordings were made on it;
/// makeWholeStomach() draws the one that is used now.
[[nodiscard]] TubeOrgan makeStomach();

/// A loop of small intestine, 200 mm long and about 27 mm wide, with gentle waves: about 20 000 triangles.
/// Its zero line is the antimesenteric border. `edges`: length of the triangles' edges over that of the
/// shipped mesh.
[[nodiscard]] TubeOrgan makeIntestine(double edges = 1.0);

/// The same in 6 724 triangles, which older recordings were made on.
[[nodiscard]] TubeOrgan makeFormerIntestine();

}  // namespace torsio
