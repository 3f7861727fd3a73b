// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/imaging/scan/scan_volume.h"
#include "sim/imaging/surface/mask_surface.h"
#include "sim/imaging/surface/scan_request.h"
#include "sim/imaging/surface/segmentation.h"
#include "sim/imaging/surface/voxel_mask.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

/// Value at which a wall ends: half way between soft tissue and fat.
inline constexpr double kWallEnd_HU = -30.0;

/// Measures the wall round a lumen of gas: from each vertex of its surface a ray leaves along the normal
/// through the scan as it is, from where the gas ends to where the soft tissue does, at most 10 mm on. Those
/// that find an end. `lumen` in metres, LPS; `level_HU` is that of its border.
[[nodiscard]] std::vector<WallRay> wallRays(const ScanVolume& scan, const TriangleMesh& lumen,
                                            double level_HU);

/// Sums rays up; none without a ray. `all`: rays that left the lumen.
[[nodiscard]] std::optional<WallThickness> wallThickness(const std::vector<WallRay>& rays, std::size_t all);

/// Shares of a lumen with its wall: soft tissue within `wall_mm` of the lumen, and no further.
[[nodiscard]] OrganShares wallShares(const WorkGrid& grid, const VoxelMask& lumen, double wall_mm);

}  // namespace torsio
