// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/imaging/scan/scan_volume.h"

namespace torsio::testing {

/// Returns a scan filled with `value`, with axes along x, y, z; `corner_mm` is the centre of the first voxel.
[[nodiscard]] ScanVolume blankScan(const std::array<std::size_t, 3>& count, const Vec3& voxel_mm,
                                   const Vec3& corner_mm, std::int16_t value = -1000);
/// Returns a blank scan around a surface in metres, with a margin.
[[nodiscard]] ScanVolume blankScanAround(const TriangleMesh& mesh, const Vec3& voxel_mm,
                                         double margin_mm = 8.0);
/// Draws a closed surface into a scan along x, y, z: voxels half inside get half of the difference.
void fillWith(ScanVolume& scan, const TriangleMesh& mesh, std::int16_t value);

/// Format of a NIfTI file.
struct NiftiStyle {
  std::int16_t datatype = 4;
  bool swapped = false;  ///< opposite of this machine's byte order
  bool sform = true;
  bool qform = false;
  float slope = 0.0F;
  float intercept = 0.0F;
  unsigned char units = 2;
  bool twoFiles = false;
};

/// Return the bytes of a header, and of a single file with its voxels.
[[nodiscard]] std::string niftiHead(const ScanVolume& scan, const NiftiStyle& style = {});
[[nodiscard]] std::string niftiVoxels(const ScanVolume& scan, const NiftiStyle& style = {});
[[nodiscard]] inline std::string niftiBytes(const ScanVolume& scan, const NiftiStyle& style = {}) {
  return niftiHead(scan, style) + niftiVoxels(scan, style);
}
/// Compresses bytes like gzip.
[[nodiscard]] std::string gzipped(const std::string& bytes);

}  // namespace torsio::testing
