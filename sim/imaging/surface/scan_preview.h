// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/imaging/surface/scan_surface.h"

namespace torsio {

/// Most voxels of a preview: 24 MB, and 12 MB of its mask.
inline constexpr double kPreviewVoxels = 12e6;

/// A scan as it is looked at: fewer voxels, nearly cubes, along the axes that are nearest to the patient's.
struct ScanPreview {
  std::string kind;  ///< "CT, 275 slices": says nothing of the patient
  /// i to the left, j to the back, k to the head; each voxel has the value of the scan at its middle.
  ScanVolume volume;
  std::vector<std::uint8_t> within;  ///< 1 for a voxel of the organ, in the order of `volume`; empty: none
  std::optional<double> volume_ml;   ///< of the organ
  std::vector<ScanRemark> remarks;
};

/// Reads a scan and makes it small enough to look at; with `find`, also the organ of the request in it.
/// Throws as surfaceOfScan().
[[nodiscard]] ScanPreview previewOfScan(const ScanRequest& request, bool find,
                                        const ScanProgress& progress = {});

/// Makes a preview of a scan that was read already.
[[nodiscard]] ScanPreview previewOfScan(const ScanRead& scan, const ScanRequest& request, bool find,
                                        double mostVoxels = kPreviewVoxels,
                                        const ScanProgress& progress = {});

}  // namespace torsio
