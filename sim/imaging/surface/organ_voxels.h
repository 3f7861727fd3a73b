// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/imaging/surface/scan_surface.h"
#include "sim/imaging/surface/voxel_mask.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

/// The voxels of an organ as its surface would be drawn round, and what is to be told of them.
struct OrganVoxels {
  WorkGrid grid;
  VoxelMask organ;
  std::vector<ScanRemark> remarks;
};

/// Finds the organ of a request in a scan, gaps of two voxels closed. Throws as surfaceOfScan().
[[nodiscard]] OrganVoxels organVoxels(const ScanRead& scan, const ScanRequest& request,
                                      const std::string& where, const ScanProgress& progress = {});

/// Reads a scan from its file or folder. Throws as surfaceOfScan().
[[nodiscard]] ScanRead readScan(const ScanRequest& request);

}  // namespace torsio
