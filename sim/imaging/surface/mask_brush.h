// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/imaging/surface/scan_request.h"
#include "sim/imaging/surface/voxel_mask.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

/// Calls `visit(x, y, z)` for each voxel of a part of a volume, [low, high), whose middle lies in a dab.
template <typename Visit>
void eachVoxelIn(const BrushDab& dab, const ScanVolume& volume, const std::array<std::size_t, 3>& low,
                 const std::array<std::size_t, 3>& high, const Visit& visit) {
  const Vec3 middle = volume.voxelAt(dab.centre_mm);
  const std::array<double, 3> at{middle.x, middle.y, middle.z};
  std::array<std::size_t, 3> first{};
  std::array<std::size_t, 3> behind{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Half of the ball in voxels, between the planes of the other two axes.
    const Vec3 planes = cross(volume.step_mm[(axis + 1) % 3], volume.step_mm[(axis + 2) % 3]);
    const double half = dab.radius_mm * norm(planes) / std::abs(volume.voxel_mm3());
    const auto least = static_cast<double>(low[axis]);
    const auto most = static_cast<double>(high[axis]);
    first[axis] = static_cast<std::size_t>(std::clamp(std::ceil(at[axis] - half), least, most));
    behind[axis] = static_cast<std::size_t>(std::clamp(std::floor(at[axis] + half) + 1.0, least, most));
  }
  for (std::size_t z = first[2]; z < behind[2]; ++z) {
    for (std::size_t y = first[1]; y < behind[1]; ++y) {
      for (std::size_t x = first[0]; x < behind[0]; ++x) {
        const Vec3 place_mm =
            volume.place_mm({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        if (norm(place_mm - dab.centre_mm) <= dab.radius_mm) {
          visit(x, y, z);
        }
      }
    }
  }
}

/// What strokes of a brush did to a mask, in voxels.
struct BrushWork {
  std::size_t added = 0;
  std::size_t erased = 0;
};

/// Mends `mask` by hand: each dab adds or erases a ball, in their order, within the scan. What was erased is
/// also taken from `tissue`, the voxels whose values say where the border lies.
BrushWork brushOver(const WorkGrid& grid, const std::vector<BrushDab>& dabs, VoxelMask& mask,
                    VoxelMask& tissue);

}  // namespace torsio
