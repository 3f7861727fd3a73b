// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/imaging/surface/scan_request.h"
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
/// and behind which air follows within 60 mm. None if there is no such layer.
[[nodiscard]] std::optional<TablePlane> tableIn(const WorkGrid& grid, const VoxelMask& within);

/// Takes the table and all that lies behind it away.
void removeTable(const WorkGrid& grid, const TablePlane& table, VoxelMask& within);

/// Shares of a label that a voxel covers are kept in thousandths.
inline constexpr float kWholeVoxel = 1000.0F;

/// Values between which the border of a tissue lies.
struct TissueLevel {
  double level = 0.0;     ///< at the border: half way between what lies inside and what lies outside
  double contrast = 1.0;  ///< value inside less that outside; negative for gas

  [[nodiscard]] bool isInside(double value) const noexcept {
    return contrast > 0.0 ? value > level : value < level;
  }
  /// Share of a voxel that lies inside, from its value, 0..1.
  [[nodiscard]] double share(double value) const noexcept;
};

/// A piece of tissue as the threshold shows it.
struct FoundPiece {
  VoxelMask piece;
  TissueLevel level;
};

/// Finds the tissue of a request: threshold, thin bridges cut, the piece of the seed or the largest; for the
/// gas of a lumen none that is open to the air round the patient. The level is half way between the medians
/// inside and outside of a first try. What there is to say is added to `remarks`. Throws
/// Error{kFileUnreadable}, D16: nothing found, no such tissue at the seed, several alike, a leak. `where`
/// names the scan.
[[nodiscard]] FoundPiece foundPiece(const WorkGrid& grid, const ScanRequest& request,
                                    const std::string& where, std::vector<ScanRemark>& remarks);

/// Finds what is denser than a threshold, the piece of the seed or the largest, nothing cut or closed: an
/// instrument. Throws as foundPiece().
[[nodiscard]] FoundPiece densePiece(const WorkGrid& grid, double threshold_HU,
                                    const std::optional<Vec3>& seed_mm, const std::string& where,
                                    std::vector<ScanRemark>& remarks);

/// The voxels of the scan, without the margin, for which `holds(x, y, z)`.
template <typename Holds>
[[nodiscard]] VoxelMask scannedWhere(const WorkGrid& grid, const Holds& holds) {
  VoxelMask mask(grid.volume.count);
  const auto [x1, y1, z1] = grid.high();
  for (std::size_t z = WorkGrid::kMargin; z < z1; ++z) {
    for (std::size_t y = WorkGrid::kMargin; y < y1; ++y) {
      for (std::size_t x = WorkGrid::kMargin; x < x1; ++x) {
        if (holds(x, y, z)) {
          mask.set(x, y, z);
        }
      }
    }
  }
  return mask;
}

/// All of them.
[[nodiscard]] VoxelMask scannedVoxels(const WorkGrid& grid);

/// Makes a whole of a piece: gaps of up to twice `closing` voxels close, ends that the scan cuts get lids,
/// holes are filled. `closing` is less than the grid's margin.
[[nodiscard]] VoxelMask wholeOrgan(const WorkGrid& grid, const VoxelMask& piece, int closing);

/// Tells where the scan cuts the organ off (D17); none where it does not.
[[nodiscard]] std::optional<ScanRemark> cutOff(const WorkGrid& grid, const VoxelMask& organ);

}  // namespace torsio
