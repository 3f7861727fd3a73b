// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "sim/base/error.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/imaging/surface/scan_surface.h"

namespace torsio {

/// What is known of an instrument in a scan. Millimetres, LPS.
struct ToolRequest {
  std::filesystem::path source;  ///< a NIfTI file, or a folder of DICOM files
  double threshold_HU = 500.0;   ///< denser: the tool
  std::optional<Vec3> seed_mm;   ///< a point in it; none: the largest piece
  std::optional<Vec3> tip_mm;    ///< near its tip; none: the narrower end
  std::optional<Vec3> shaft;     ///< direction from the tip to the hand; none: found
  std::optional<Vec3> jawAxis;   ///< that the jaws turn about; none: across the broad side of the jaws
  double pivot_mm = 20.0;        ///< from the tip to the hinge of the jaws
  int series = 0;
  bool resample = false;
};

/// An instrument as a scan shows it, in its own frame: tip at the origin, shaft along +z, jaws opening about
/// x, the upper one at y > 0. Metres, closed surfaces.
struct ToolSurface {
  TriangleMesh shaft;
  TriangleMesh upperJaw;
  TriangleMesh lowerJaw;
  double length_mm = 0.0;       ///< from the tip to the end
  double pivot_mm = 0.0;        ///< from the tip to the hinge
  double shaftRadius_mm = 0.0;  ///< of the round section with the area of the shaft's
  double tipRadius_mm = 0.0;    ///< of the round section with the area of the front half of the closed jaws
  Vec3 tip_mm;                  ///< in the scan
  std::array<Vec3, 3> axes;     ///< of the frame, in the scan
  std::vector<ScanRemark> remarks;
};

/// Checks a request before anything is read. Throws Error{kBadParameter}.
inline void requireToolRequest(const ToolRequest& request) {
  const auto finite = [](const std::optional<Vec3>& v) { return !v || std::isfinite(v->x + v->y + v->z); };
  const auto direction = [](const std::optional<Vec3>& v) { return !v || norm(*v) > 0.0; };
  if (!(request.threshold_HU >= -500.0 && request.threshold_HU <= 3000.0) ||
      !(request.pivot_mm >= 3.0 && request.pivot_mm <= 100.0) || !finite(request.tip_mm) ||
      !finite(request.seed_mm) || !finite(request.shaft) || !finite(request.jawAxis) ||
      !direction(request.shaft) || !direction(request.jawAxis)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("what is said of the instrument is out of range"), "",
                Text::tr("Give a threshold of -500 to 3000 HU, a hinge 3 to 100 mm behind the tip, and "
                         "directions that are not zero"));
  }
}

/// Finds the instrument in a scan: what is denser than the threshold, cut into shaft and jaws at the hinge
/// and between the jaws. Throws as surfaceOfScan(); D16 also for a tool that is shorter than twice its jaws.
[[nodiscard]] ToolSurface toolOfScan(const ScanRead& scan, const ToolRequest& request,
                                     const std::string& where, const ScanProgress& progress = {});

/// Reads the scan first.
[[nodiscard]] ToolSurface toolOfScan(const ToolRequest& request, const ScanProgress& progress = {});

}  // namespace torsio
