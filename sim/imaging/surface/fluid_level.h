// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/imaging/surface/segmentation.h"

namespace torsio {

/// Finds the fluid that stands below the gas of a lumen: the flat level at which the gas ends, towards the
/// back, the front, the left or the right (whichever way the patient lay), and from there downwards what has
/// the density of the fluid, thin bridges cut. Water-like fluid and contrast; the border to the wall lies
/// half way between their densities, a mean over 27 voxels against the noise. Returns the voxels of fluid
/// with the gap to the gas; what there is to say is added to `remarks`. Throws Error{kFileUnreadable}, D16:
/// no flat level, a fluid as dense as the wall, a leak. `gas`: of foundPiece().
[[nodiscard]] VoxelMask fluidBelow(const WorkGrid& grid, const VoxelMask& gas, const std::string& where,
                                   std::vector<ScanRemark>& remarks);

}  // namespace torsio
