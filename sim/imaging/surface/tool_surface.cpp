// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/tool_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/core/short_number.h"
#include "sim/geometry/mesh/mesh_pieces.h"
#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/geometry/mesh/mesh_thinning.h"
#include "sim/imaging/surface/mask_surface.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/imaging/surface/segmentation.h"

namespace torsio {

namespace {

constexpr double kMaxToolVoxels = 24e6;
constexpr double kToolBlur = 0.6;  // voxels
constexpr int kToolPasses = 10;
constexpr std::size_t kToolTriangles = 4'000;  // of a part

WorkGrid toolGrid(const ScanVolume& scan, const std::string& where) {
  return workGrid(
      scan, rangeOf(scan, std::nullopt, where), kMaxToolVoxels,
      [](std::int16_t value) { return static_cast<float>(value); }, kOutsideScan_HU);
}

ToolPoints voxelsOf(const WorkGrid& grid, const OrganShares& part) {
  ToolPoints voxels;
  voxels.solid = 0.5;
  voxels.halfPoint_mm = 0.5 * grid.step_mm;
  eachVoxelOf(part, [&](std::size_t n, std::size_t x, std::size_t y, std::size_t z) {
    if (part.shares[n] > 0.0F) {
      voxels.places_mm.push_back(
          grid.volume.place_mm({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}));
      voxels.shares.push_back(static_cast<double>(part.shares[n]));
    }
  });
  return voxels;
}

/// Cubic millimetres of the tool between two places along its shaft.
double filledBetween(const WorkGrid& grid, const ToolPoints& voxels, const ToolFrame& frame, double low_mm,
                     double high_mm) {
  return shareBetween(voxels, frame.tip_mm, frame.z, low_mm, high_mm) * std::abs(grid.volume.voxel_mm3());
}

double roundRadius_mm(double volume_mm3, double length_mm) {
  return length_mm > 0.0 ? std::sqrt(std::max(volume_mm3, 0.0) / (length_mm * kPi)) : 0.0;
}

/// The part of a tool on the near side of planes; a voxel that is cut keeps its share.
using PlaneDistance = double (*)(const Vec3& local_mm, double pivot_mm);

TriangleMesh partOf(const WorkGrid& grid, OrganShares part, const ToolFrame& frame, double pivot_mm,
                    PlaneDistance inside_mm) {
  eachVoxelOf(part, [&](std::size_t n, std::size_t x, std::size_t y, std::size_t z) {
    const Vec3 place_mm =
        grid.volume.place_mm({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    const double share = 0.5 + inside_mm(frame.local_mm(place_mm), pivot_mm) / grid.step_mm;
    part.shares[n] *= static_cast<float>(std::clamp(share, 0.0, 1.0));
  });
  TriangleMesh mesh = surfaceOf(std::move(part), grid.volume, kToolBlur);
  if (mesh.triangles.empty()) {
    return mesh;
  }
  MeshRepairs ignored;
  static_cast<void>(keepMainComponent(mesh, 1.0, ignored));
  removeUnusedVertices(mesh, ignored);
  smooth(mesh, kToolPasses);
  mesh = thinned(std::move(mesh), kToolTriangles);
  for (Vec3& v : mesh.vertices_m) {
    v = frame.local_mm(kToolMetre_mm * v) / kToolMetre_mm;
  }
  return mesh;
}

}  // namespace

ToolSurface toolOfScan(const ScanRead& scan, const ToolRequest& request, const std::string& where,
                       const ScanProgress& progress) {
  requireToolRequest(request);
  const auto tell = [&progress](ScanStep step) {
    if (progress) {
      progress(step, 0.0);
    }
  };
  tell(ScanStep::kSegmenting);
  ToolSurface tool;
  tool.remarks = scan.remarks;
  const WorkGrid grid = toolGrid(scan.volume, where);
  const FoundPiece found = densePiece(grid, request.threshold_HU, request.seed_mm, where, tool.remarks);
  const OrganShares shares = organShares(grid, found.piece.filled(), found);
  const ToolPoints voxels = voxelsOf(grid, shares);
  const ToolFrame frame = toolFrame(voxels, request);
  tool.tip_mm = frame.tip_mm;
  tool.pivot_mm = request.pivot_mm;
  tool.axes = {frame.x, frame.y, frame.z};
  tool.length_mm = reachAlong(voxels, frame.tip_mm, frame.z).second + voxels.halfPoint_mm;
  if (!(tool.length_mm > 2.0 * request.pivot_mm)) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("D16 the part denser than %1 HU is %2 mm long, which does not suit an instrument "
                         "with jaws of %3 mm",
                         shortNumber(request.threshold_HU), shortNumber(tool.length_mm),
                         shortNumber(request.pivot_mm)),
                where, Text::tr("Give another threshold, a seed in the instrument, or its hinge"));
  }
  const double shaftFrom_mm = request.pivot_mm + kBehindHinge_mm;
  const double shaftTo_mm = std::max(tool.length_mm - kBehindHinge_mm, shaftFrom_mm + 1.0);
  tool.shaftRadius_mm =
      roundRadius_mm(filledBetween(grid, voxels, frame, shaftFrom_mm, shaftTo_mm), shaftTo_mm - shaftFrom_mm);
  tool.tipRadius_mm =
      roundRadius_mm(filledBetween(grid, voxels, frame, 0.1 * request.pivot_mm, 0.5 * request.pivot_mm),
                     0.4 * request.pivot_mm);
  tell(ScanStep::kDrawing);
  tool.shaft = partOf(grid, shares, frame, request.pivot_mm,
                      [](const Vec3& at, double pivot_mm) { return at.z - pivot_mm; });
  tool.upperJaw = partOf(grid, shares, frame, request.pivot_mm,
                         [](const Vec3& at, double pivot_mm) { return std::min(pivot_mm - at.z, at.y); });
  tool.lowerJaw = partOf(grid, shares, frame, request.pivot_mm,
                         [](const Vec3& at, double pivot_mm) { return std::min(pivot_mm - at.z, -at.y); });
  if (tool.shaft.triangles.empty() || tool.upperJaw.triangles.empty() || tool.lowerJaw.triangles.empty()) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("D16 the instrument has no two jaws in front of its hinge"), where,
                Text::tr("Give the hinge, its axis, and a point near the tip"));
  }
  tellPlaces(request, tool.axes[0], tool.pivot_mm, tool.remarks);
  return tool;
}

ToolSurface toolOfScan(const ToolRequest& request, const ScanProgress& progress) {
  if (progress) {
    progress(ScanStep::kReading, 0.0);
  }
  requireToolRequest(request);
  ScanRequest scan;
  scan.source = request.source;
  scan.series = request.series;
  scan.resample = request.resample;
  return toolOfScan(readScan(scan), request, request.source.string(), progress);
}

}  // namespace torsio
