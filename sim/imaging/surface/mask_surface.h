// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/imaging/surface/segmentation.h"
#include "sim/imaging/surface/voxel_mask.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

/// How much of each voxel of a part of a grid lies within an organ, 0..1; 0 on the border of the part.
struct OrganShares {
  std::array<std::size_t, 3> first{};  ///< the part's first voxel in the grid
  std::array<std::size_t, 3> count{};
  std::vector<float> shares;  ///< x fastest
};

/// Calls `visit(n, x, y, z)` for each voxel of a part: its place in `shares`, and in the grid.
template <typename Visit>
void eachVoxelOf(const OrganShares& part, const Visit& visit) {
  std::size_t n = 0;
  for (std::size_t z = part.first[2]; z < part.first[2] + part.count[2]; ++z) {
    for (std::size_t y = part.first[1]; y < part.first[1] + part.count[1]; ++y) {
      for (std::size_t x = part.first[0]; x < part.first[0] + part.count[0]; ++x, ++n) {
        visit(n, x, y, z);
      }
    }
  }
}

/// The part of a grid in which a mask lies, with room for the blur, and nothing in it yet.
[[nodiscard]] OrganShares emptyShares(const VoxelMask& mask);

/// Takes the shares from the values of the scan where the organ's border is that of its tissue, and whole
/// voxels where it was closed or filled.
[[nodiscard]] OrganShares organShares(const WorkGrid& grid, const VoxelMask& organ, const FoundPiece& found);

/// The voxels that lie within by half or more, in a grid of `count` voxels.
[[nodiscard]] VoxelMask maskOf(const OrganShares& shares, const VoxelMask::Count& count);

/// Shares that agree with a mask about every voxel, changed no more than that needs.
[[nodiscard]] OrganShares agreeing(OrganShares shares, const VoxelMask& organ);

/// The volume that they make up, cubic millimetres.
[[nodiscard]] double volume_mm3(const OrganShares& shares, const ScanVolume& grid);

/// Draws the surface at which half of a voxel lies within: the shares are blurred (Gaussian, `blur` voxels),
/// the surface is cut by marching tetrahedra. Metres, LPS, closed, outwards.
[[nodiscard]] TriangleMesh surfaceOf(OrganShares shares, const ScanVolume& grid, double blur);

}  // namespace torsio
