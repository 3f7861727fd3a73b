// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/tool_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/portable_math.h"
#include "sim/base/short_number.h"
#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/geometry/mesh/mesh_smoothing.h"
#include "sim/geometry/mesh/mesh_thinning.h"
#include "sim/imaging/surface/mask_surface.h"
#include "sim/imaging/surface/organ_voxels.h"
#include "sim/imaging/surface/segmentation.h"

namespace torsio {

namespace {

constexpr double kMostToolVoxels = 24e6;
constexpr double kToolBlur = 0.6;  // voxels
constexpr int kToolPasses = 10;
constexpr std::size_t kToolTriangles = 4'000;  // of a part
constexpr double kBehindHinge_mm = 5.0;        // where the shaft is round
constexpr double kToolMetre_mm = 1e3;

/// The voxels of a tool and how much of each it fills.
struct ToolVoxels {
  std::vector<Vec3> places_mm;
  std::vector<double> shares;
};

/// A line through a tool, and the frame on it.
struct ToolFrame {
  Vec3 tip_mm;
  Vec3 x;
  Vec3 y;
  Vec3 z;  ///< from the tip to the hand
  [[nodiscard]] Vec3 local_mm(const Vec3& place_mm) const {
    const Vec3 from = place_mm - tip_mm;
    return {dot(from, x), dot(from, y), dot(from, z)};
  }
};

/// Mean and longest direction of voxels for which `wanted` holds true.
template <typename Wanted>
std::pair<Vec3, Vec3> lineThrough(const ToolVoxels& voxels, const Vec3& start, const Wanted& wanted) {
  Vec3 sum;
  double weight = 0.0;
  for (std::size_t n = 0; n < voxels.shares.size(); ++n) {
    if (wanted(voxels.places_mm[n])) {
      sum += voxels.shares[n] * voxels.places_mm[n];
      weight += voxels.shares[n];
    }
  }
  const Vec3 middle = weight > 0.0 ? sum / weight : start;
  std::array<Vec3, 3> spread{};
  for (std::size_t n = 0; n < voxels.shares.size(); ++n) {
    if (wanted(voxels.places_mm[n])) {
      const Vec3 from = voxels.places_mm[n] - middle;
      spread[0] += voxels.shares[n] * from.x * from;
      spread[1] += voxels.shares[n] * from.y * from;
      spread[2] += voxels.shares[n] * from.z * from;
    }
  }
  constexpr int kRounds = 200;  // of the power method; a tool is much longer than wide
  Vec3 direction = normalized(start + Vec3{1e-3, 2e-3, 3e-3});
  for (int round = 0; round < kRounds; ++round) {
    const Vec3 next{dot(spread[0], direction), dot(spread[1], direction), dot(spread[2], direction)};
    if (norm(next) == 0.0) {
      break;
    }
    direction = normalized(next);
  }
  return {middle, direction};
}

WorkGrid toolGrid(const ScanVolume& scan, const std::string& where) {
  return workGrid(
      scan, rangeOf(scan, std::nullopt, where), kMostToolVoxels,
      [](std::int16_t value) { return static_cast<float>(value); }, kOutsideScan_HU);
}

ToolVoxels voxelsOf(const WorkGrid& grid, const OrganShares& part) {
  ToolVoxels voxels;
  eachVoxelOf(part, [&](std::size_t n, std::size_t x, std::size_t y, std::size_t z) {
    if (part.shares[n] > 0.0F) {
      voxels.places_mm.push_back(
          grid.volume.place_mm({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}));
      voxels.shares.push_back(static_cast<double>(part.shares[n]));
    }
  });
  return voxels;
}

/// Least and most of the voxels along a direction, half of a voxel's share beyond its middle.
std::pair<double, double> reachAlong(const ToolVoxels& voxels, const Vec3& from, const Vec3& direction) {
  double least = 1e9;
  double most = -1e9;
  for (std::size_t n = 0; n < voxels.shares.size(); ++n) {
    if (voxels.shares[n] >= 0.5) {
      const double at = dot(voxels.places_mm[n] - from, direction);
      least = std::min(least, at);
      most = std::max(most, at);
    }
  }
  return {least, most};
}

/// Cubic millimetres of the tool between two places along a line.
double filledBetween(const WorkGrid& grid, const ToolVoxels& voxels, const Vec3& from, const Vec3& direction,
                     double low_mm, double high_mm) {
  double sum = 0.0;
  for (std::size_t n = 0; n < voxels.shares.size(); ++n) {
    const double at = dot(voxels.places_mm[n] - from, direction);
    sum += at >= low_mm && at < high_mm ? voxels.shares[n] : 0.0;
  }
  return sum * std::abs(grid.volume.voxel_mm3());
}

double roundRadius_mm(double volume_mm3, double length_mm) {
  return length_mm > 0.0 ? std::sqrt(std::max(volume_mm3, 0.0) / (length_mm * kPi)) : 0.0;
}

/// Which way the tip lies.
Vec3 fromTipToHand(const WorkGrid& grid, const ToolVoxels& voxels, const ToolRequest& request,
                   const Vec3& middle, Vec3 direction) {
  if (request.shaft) {
    return dot(direction, *request.shaft) < 0.0 ? -1.0 * direction : direction;
  }
  if (request.tip_mm) {
    return dot(direction, middle - *request.tip_mm) < 0.0 ? -1.0 * direction : direction;
  }
  const auto [least, most] = reachAlong(voxels, middle, direction);
  const double low = filledBetween(grid, voxels, middle, direction, least, least + request.pivot_mm);
  const double high = filledBetween(grid, voxels, middle, direction, most - request.pivot_mm, most);
  return high < low ? -1.0 * direction : direction;
}

/// The direction across a shaft in which the jaws are broadest, which their hinge runs along when they are
/// closed.
Vec3 broadestAcross(const ToolVoxels& voxels, const ToolFrame& frame, double pivot_mm) {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::size_t n = 0; n < voxels.shares.size(); ++n) {
    const Vec3 at = frame.local_mm(voxels.places_mm[n]);
    if (at.z < 0.8 * pivot_mm) {
      xx += voxels.shares[n] * at.x * at.x;
      yy += voxels.shares[n] * at.y * at.y;
      xy += voxels.shares[n] * at.x * at.y;
    }
  }
  // The longer axis of the ellipse of inertia.
  const double apart = std::hypot(xx - yy, 2.0 * xy);
  const Vec3 along = (xx - yy + apart) * frame.x + 2.0 * xy * frame.y;
  return norm(along) > 0.0 ? along : frame.y;
}

void turnAcross(ToolFrame& frame, const Vec3& towards) {
  const Vec3 across = towards - dot(towards, frame.z) * frame.z;
  frame.x = normalized(across);
  frame.y = cross(frame.z, frame.x);
}

ToolFrame frameOf(const WorkGrid& grid, const ToolVoxels& voxels, const ToolRequest& request) {
  const auto all = [](const Vec3&) { return true; };
  const auto whole = lineThrough(voxels, request.shaft.value_or(Vec3{0, 0, 1}), all);
  Vec3 middle = whole.first;
  ToolFrame frame;
  frame.z = fromTipToHand(grid, voxels, request, middle, whole.second);
  for (int round = 0; round < 3; ++round) {  // the line of the shaft alone, without the jaws
    const double least = reachAlong(voxels, middle, frame.z).first;
    const auto [shaftMiddle, shaft] = lineThrough(voxels, frame.z, [&](const Vec3& place_mm) {
      return dot(place_mm - middle, frame.z) > least + request.pivot_mm + kBehindHinge_mm;
    });
    frame.z = request.shaft ? normalized(*request.shaft) : dot(shaft, frame.z) < 0.0 ? -1.0 * shaft : shaft;
    middle = shaftMiddle;
  }
  const double least = reachAlong(voxels, middle, frame.z).first;
  frame.tip_mm = middle + (least - 0.5 * grid.step_mm) * frame.z;
  const Vec3 any = std::abs(frame.z.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  turnAcross(frame, any);
  turnAcross(frame, request.jawAxis ? *request.jawAxis : broadestAcross(voxels, frame, request.pivot_mm));
  return frame;
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

void tellPlaces(const ToolRequest& request, const ToolSurface& tool, std::vector<ScanRemark>& remarks) {
  if (!request.jawAxis) {
    remarks.push_back(
        {"D22", false,
         Text::tr("the jaws are taken to turn about their broad side, %1, %2, %3 in the scan",
                  shortNumber(tool.axes[0].x), shortNumber(tool.axes[0].y), shortNumber(tool.axes[0].z)),
         std::nullopt, Text::tr("Give the axis of the hinge where it is another")});
  }
  constexpr double kFeltJaw_mm = 20.0;
  if (std::abs(request.pivot_mm - kFeltJaw_mm) > 0.5) {
    remarks.push_back({"D22", true,
                       Text::tr("the jaws are %1 mm long; the force is computed with jaws of %2 mm",
                                shortNumber(request.pivot_mm), shortNumber(kFeltJaw_mm)),
                       request.pivot_mm, Text::tr("Use the instrument for what is seen")});
  }
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
  const ToolVoxels voxels = voxelsOf(grid, shares);
  const ToolFrame frame = frameOf(grid, voxels, request);
  tool.tip_mm = frame.tip_mm;
  tool.pivot_mm = request.pivot_mm;
  tool.axes = {frame.x, frame.y, frame.z};
  tool.length_mm = reachAlong(voxels, frame.tip_mm, frame.z).second + 0.5 * grid.step_mm;
  if (!(tool.length_mm > 2.0 * request.pivot_mm)) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("D16 what is denser than %1 HU is %2 mm long: no instrument with jaws of %3 mm",
                         shortNumber(request.threshold_HU), shortNumber(tool.length_mm),
                         shortNumber(request.pivot_mm)),
                where, Text::tr("Give another threshold, a seed in the instrument, or its hinge"));
  }
  const double shaftFrom_mm = request.pivot_mm + kBehindHinge_mm;
  const double shaftTo_mm = std::max(tool.length_mm - kBehindHinge_mm, shaftFrom_mm + 1.0);
  tool.shaftRadius_mm =
      roundRadius_mm(filledBetween(grid, voxels, frame.tip_mm, frame.z, shaftFrom_mm, shaftTo_mm),
                     shaftTo_mm - shaftFrom_mm);
  tool.tipRadius_mm = roundRadius_mm(
      filledBetween(grid, voxels, frame.tip_mm, frame.z, 0.1 * request.pivot_mm, 0.5 * request.pivot_mm),
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
  tellPlaces(request, tool, tool.remarks);
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
