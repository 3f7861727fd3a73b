// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A surgeon's right hand in a glove, closed about the end of the grasper's shaft, with the cuff of the gown;
/// metres, in the frame of the instrument (tip at the origin, shaft along +z).
[[nodiscard]] TriangleMesh makeGlovedHand();

}  // namespace torsio
