// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

#include "sim/core/vec3.h"
#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

/// A direction along an axis of a grid.
struct GridWay {
  std::size_t axis = 0;
  bool backwards = false;  ///< towards smaller numbers of voxels
};

/// Returns the direction of a grid that is nearest to one of the patient's.
[[nodiscard]] inline GridWay wayNearest(const ScanVolume& grid, const Vec3& direction) {
  GridWay best;
  double most = -1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = dot(grid.step_mm[axis], direction) / norm(grid.step_mm[axis]);
    if (std::abs(along) > most) {
      most = std::abs(along);
      best = {axis, along < 0.0};
    }
  }
  return best;
}

}  // namespace torsio
