// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/imaging/tool/tool_frame.h"

namespace torsio {

/// What is known of an instrument in a scan. Millimetres, LPS.
struct ToolRequest : ToolPlaces {
  std::filesystem::path source;  ///< a NIfTI file, or a folder of DICOM files
  double threshold_HU = 500.0;   ///< denser: the tool
  std::optional<Vec3> seed_mm;   ///< a point in it; none: the largest piece
  int series = 0;
  bool resample = false;
};

/// An instrument as a scan or a mesh shows it, in its own frame: tip at the origin, shaft along +z, jaws
/// opening about x, the upper one at y > 0. Metres, closed surfaces.
struct ToolSurface {
  TriangleMesh shaft;
  TriangleMesh upperJaw;
  TriangleMesh lowerJaw;
  double length_mm = 0.0;       ///< from the tip to the end
  double pivot_mm = 0.0;        ///< from the tip to the hinge
  double shaftRadius_mm = 0.0;  ///< of the round section with the area of the shaft's
  double tipRadius_mm = 0.0;    ///< of the round section with the area of the front half of the closed jaws
  Vec3 tip_mm;                  ///< in the axes of the scan or file
  std::array<Vec3, 3> axes;     ///< of the frame, in the same
  std::vector<ScanRemark> remarks;
};

/// Checks a request before anything is read. Throws Error{kBadParameter}.
inline void requireToolRequest(const ToolRequest& request) {
  requireToolPlaces(request, request.threshold_HU >= -500.0 && request.threshold_HU <= 3000.0 &&
                                 (!request.seed_mm || isFinite(*request.seed_mm)));
}

/// Finds the instrument in a scan: what is denser than the threshold, cut into shaft and jaws at the hinge
/// and between the jaws. Throws as surfaceOfScan(); D16 also for a tool that is shorter than twice its jaws.
[[nodiscard]] ToolSurface toolOfScan(const ScanRead& scan, const ToolRequest& request,
                                     const std::string& where, const ScanProgress& progress = {});

/// Reads the scan first.
[[nodiscard]] ToolSurface toolOfScan(const ToolRequest& request, const ScanProgress& progress = {});

}  // namespace torsio
