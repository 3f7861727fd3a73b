// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/mask_brush.h"

namespace torsio {

BrushWork brushOver(const WorkGrid& grid, const std::vector<BrushDab>& dabs, VoxelMask& mask,
                    VoxelMask& tissue) {
  const VoxelMask before = mask;
  for (std::size_t first = 0; first < dabs.size();) {
    VoxelMask stroke(mask.count());
    std::size_t behind = first;
    for (; behind < dabs.size() && dabs[behind].adds == dabs[first].adds; ++behind) {
      eachVoxelIn(dabs[behind], grid.volume, grid.low(), grid.high(),
                  [&stroke](std::size_t x, std::size_t y, std::size_t z) { stroke.set(x, y, z); });
    }
    if (dabs[first].adds) {
      mask.add(stroke);
    } else {
      mask.remove(stroke);
      tissue.remove(stroke);
    }
    first = behind;
  }
  VoxelMask added = mask;
  added.remove(before);
  VoxelMask erased = before;
  erased.remove(mask);
  return {added.voxels(), erased.voxels()};
}

}  // namespace torsio
