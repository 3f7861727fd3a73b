// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "sim/imaging/surface/voxel_mask.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

/// Where the table begins on which a patient lies.
struct TablePlane {
  std::size_t axis = 0;    ///< of the grid
  std::size_t first = 0;   ///< its first layer of voxels along it
  bool backwards = false;  ///< what lies at smaller numbers is the table
  double at_mm = 0.0;      ///< of its top along the patient's back
};

/// Finds a flat table among what is denser than air: the first layer, from the middle of the patient towards
/// the back or, else, the front, that is full from one side of the scan to the other in nearly every slice,
/// and behind which air follows within 60 mm. None where there is no such layer.
[[nodiscard]] std::optional<TablePlane> tableIn(const WorkGrid& grid, const VoxelMask& within);

/// Takes the table and all that lies behind it away.
void removeTable(const WorkGrid& grid, const TablePlane& table, VoxelMask& within);

}  // namespace torsio
