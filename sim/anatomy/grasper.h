// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A straight laparoscopic grasper of 5 mm. Metres; tip at the origin, shaft along +z towards the hand. The
/// jaws are drawn closed; they turn about `jawPivot_m` and the x axis, the upper (y > 0) by +angle, the lower
/// by -angle.
struct Grasper {
  TriangleMesh shaft;
  TriangleMesh upperJaw;
  TriangleMesh lowerJaw;
  Vec3 jawPivot_m;
  double shaftLength_m = 0.0;  ///< from the tip
  double shaftRadius_m = 0.0;
  double jawOpening_rad = 0.0;  ///< of each jaw, fully open
};

[[nodiscard]] Grasper makeGrasper();

/// A surgeon's right hand in a glove, closed about the end of the grasper's shaft, with the cuff of the gown;
/// metres, in the frame of the instrument (tip at the origin, shaft along +z).
[[nodiscard]] TriangleMesh makeGlovedHand();

}  // namespace torsio
