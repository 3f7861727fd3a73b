// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/core/text.h"
#include "sim/imaging/surface/scan_request.h"
#include "sim/imaging/surface/voxel_mask.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

/// What is being done with a scan.
enum class ScanStep { kReading, kSegmenting, kDrawing, kThinning, kMeasuring };

/// Told what is done now and how much of it, 0..1.
using ScanProgress = std::function<void(ScanStep step, double fraction)>;

/// Reads a scan, finds the organ in it and draws its surface: closed, smoothed, about kKeptTriangles. Not yet
/// checked as an organ. In this process: files of users are read by scanApart(). Throws Error{kFileMissing,
/// kFileUnreadable} with the code of the rule (D01 to D18, N01 to N07), {kBadParameter} for a request out of
/// range.
[[nodiscard]] ScanSurface surfaceOfScan(const ScanRequest& request, const ScanProgress& progress = {});

/// Finds the organ in a scan that was read already and draws its surface, as surfaceOfScan(request); `where`
/// names the scan.
[[nodiscard]] ScanSurface surfaceOfScan(ScanRead scan, const ScanRequest& request, const std::string& where,
                                        const ScanProgress& progress = {});

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

/// What is done with a scan, in words, and where in the whole it begins and ends.
struct ScanStepShare {
  Text words;
  double from = 0.0;
  double to = 1.0;
  /// Place in the whole of a fraction of the step.
  [[nodiscard]] double at(double fraction) const noexcept { return from + (to - from) * fraction; }
};

[[nodiscard]] inline ScanStepShare shareOf(ScanStep step) {
  switch (step) {
    case ScanStep::kReading:
      return {Text::tr("Reading the scan"), 0.0, 0.3};
    case ScanStep::kSegmenting:
      return {Text::tr("Looking for the organ"), 0.3, 0.5};
    case ScanStep::kDrawing:
      return {Text::tr("Drawing its surface"), 0.5, 0.7};
    case ScanStep::kThinning:
      return {Text::tr("Smoothing and thinning"), 0.7, 0.9};
    case ScanStep::kMeasuring:
      break;
  }
  return {Text::tr("Measuring the wall"), 0.9, 1.0};
}

}  // namespace torsio
