// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/imaging/scan/scan_volume.h"

namespace torsio::testing {

/// A scan of nothing but `value`, its axes along x, y, z; `corner_mm` is the middle of the first voxel.
[[nodiscard]] ScanVolume blankScan(const std::array<std::size_t, 3>& count, const Vec3& voxel_mm,
                                   const Vec3& corner_mm, std::int16_t value = -1000);
/// A blank scan around a surface in metres, with a margin.
[[nodiscard]] ScanVolume blankScanAround(const TriangleMesh& mesh, const Vec3& voxel_mm,
                                         double margin_mm = 8.0);
/// Puts a closed surface into a scan along x, y, z: voxels that lie half inside get half of the difference.
void fillWith(ScanVolume& scan, const TriangleMesh& mesh, std::int16_t value);

/// How a NIfTI file is written.
struct NiftiStyle {
  std::int16_t datatype = 4;
  bool swapped = false;  ///< in the byte order that this machine has not
  bool sform = true;
  bool qform = false;
  float slope = 0.0F;
  float intercept = 0.0F;
  unsigned char units = 2;
  bool twoFiles = false;
};

/// The bytes of a header and, in one file, of what follows it.
[[nodiscard]] std::string niftiHead(const ScanVolume& scan, const NiftiStyle& style = {});
[[nodiscard]] std::string niftiVoxels(const ScanVolume& scan, const NiftiStyle& style = {});
[[nodiscard]] inline std::string niftiBytes(const ScanVolume& scan, const NiftiStyle& style = {}) {
  return niftiHead(scan, style) + niftiVoxels(scan, style);
}
/// Packs bytes as gzip does.
[[nodiscard]] std::string gzipped(const std::string& bytes);

}  // namespace torsio::testing
