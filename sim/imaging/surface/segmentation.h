// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/imaging/surface/scan_request.h"
#include "sim/imaging/surface/voxel_mask.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

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

/// The voxels of the scan, without the margin.
[[nodiscard]] VoxelMask scannedVoxels(const WorkGrid& grid);

/// Makes a whole of a piece: gaps of up to twice `closing` voxels close, ends that the scan cuts get lids,
/// holes are filled. `closing` is less than the grid's margin.
[[nodiscard]] VoxelMask wholeOrgan(const WorkGrid& grid, const VoxelMask& piece, int closing);

/// Tells where the scan cuts the organ off (D17); none where it does not.
[[nodiscard]] std::optional<ScanRemark> cutOff(const WorkGrid& grid, const VoxelMask& organ);

}  // namespace torsio
