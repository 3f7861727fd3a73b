// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/imaging/scan/scan_volume.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

/// What of a scan the organ is.
enum class ScanTissue {
  kSkin,      ///< everything within the skin: an arm
  kGasLumen,  ///< the inside of an organ that is filled with gas
  kWall,      ///< such an organ with its wall
  kLabel,     ///< a number of a label mask
};

/// A ball that is added to an organ's voxels by hand, or erased from them.
struct BrushDab {
  Vec3 centre_mm;  ///< LPS
  double radius_mm = 0.0;
  bool adds = true;
  friend bool operator==(const BrushDab&, const BrushDab&) = default;
};

/// Most dabs of a request, and their radii.
inline constexpr std::size_t kMaxDabs = 20'000;
inline constexpr double kLeastDab_mm = 0.25;
inline constexpr double kMaxDab_mm = 100.0;

/// What is to be made of a scan.
struct ScanRequest {
  std::filesystem::path source{};  ///< a NIfTI file, or a folder of DICOM files
  ScanTissue tissue = ScanTissue::kSkin;
  int label = 0;                    ///< 1 to 32767, of kLabel
  std::optional<Vec3> seed_mm{};    ///< a point inside, LPS
  std::optional<ScanBox> box_mm{};  ///< what to look at
  std::optional<double> wall_mm{};  ///< its thickness, where it is known
  int series = 0;                   ///< which of several series, from 1; 0: the one with the most slices
  bool resample = false;            ///< take slices at uneven distances
  bool fluid = false;               ///< of a lumen: with the fluid that stands below the gas
  std::vector<BrushDab> brush{};    ///< mends the organ's voxels, in this order
};

/// Checks a request before anything is read. Throws Error{kBadParameter}.
inline void requireScanRequest(const ScanRequest& request) {
  constexpr int kMaxLabel = 32'767;
  if (request.tissue == ScanTissue::kLabel && (request.label < 1 || request.label > kMaxLabel)) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("a label must lie between 1 and %1", std::to_string(kMaxLabel)), "",
                Text::tr("Name a label of the mask: --tissue label N"));
  }
  if (request.fluid && request.tissue != ScanTissue::kGasLumen && request.tissue != ScanTissue::kWall) {
    throw Error(ErrorCode::kBadParameter, Text::tr("fluid is found only below gas"), "",
                Text::tr("Choose gas or the wall as the tissue, or leave the fluid out"));
  }
  const auto wrong = [](const BrushDab& dab) {
    return !(dab.radius_mm >= kLeastDab_mm && dab.radius_mm <= kMaxDab_mm) ||
           !std::isfinite(dab.centre_mm.x + dab.centre_mm.y + dab.centre_mm.z);
  };
  if (request.brush.size() > kMaxDabs || std::any_of(request.brush.begin(), request.brush.end(), wrong)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("the strokes of the brush are too many or too large"), "",
                Text::tr("Correct the mask with fewer strokes"));
  }
}

/// Thickness of a wall along the rays on which a scan shows where it ends.
struct WallThickness {
  double median_mm = 0.0;
  double tenth_mm = 0.0;   ///< a tenth of the rays is thinner
  double ninety_mm = 0.0;  ///< nine tenths are thinner
  double seen = 0.0;       ///< share of the rays that end in fat or gas; elsewhere another organ lies behind
};

/// The wall where one ray leaves the lumen.
struct WallRay {
  Vec3 place_mm;  ///< on the lumen, LPS
  double thickness_mm = 0.0;
};

/// What became of it.
struct ScanSurface {
  TriangleMesh mesh;  ///< metres, LPS; closed, outwards
  std::vector<ScanRemark> remarks;
  std::string kind;  ///< "CT, 275 slices": says nothing of the patient
  std::array<std::size_t, 3> count{};
  Vec3 voxel_mm;                      ///< sides of the scan's voxels
  double step_mm = 0.0;               ///< side of the voxels that the surface was drawn on
  std::optional<double> level_HU;     ///< at which it was drawn
  std::optional<WallThickness> wall;  ///< as the scan shows it, of a kGasLumen or a kWall
  std::vector<WallRay> wallRays;      ///< those that see an end of it
  std::optional<double> ownWall_mm;   ///< of a kWall: given, measured, or assumed with a warning
  std::size_t rawTriangles = 0;       ///< before thinning
};

/// Triangles of the surface that is kept.
inline constexpr std::size_t kKeptTriangles = 20'000;

}  // namespace torsio
