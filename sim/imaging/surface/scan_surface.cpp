// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/scan_surface.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/core/text.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_pieces.h"
#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/geometry/mesh/mesh_thinning.h"
#include "sim/imaging/scan/dicom_series.h"
#include "sim/imaging/scan/nifti_file.h"
#include "sim/imaging/surface/fluid_level.h"
#include "sim/imaging/surface/mask_surface.h"
#include "sim/imaging/surface/segmentation.h"
#include "sim/imaging/surface/voxel_mask.h"
#include "sim/imaging/surface/wall_thickness.h"

namespace torsio {

namespace {

constexpr double kMaxWorkVoxels = 16e6;
constexpr int kMaxClosing = 3;     // voxels
constexpr double kSoftBlur = 0.6;  // voxels: shares of voxels are smooth already
constexpr double kHardBlur = 0.9;  // whole voxels are stairs
constexpr int kSmoothingPasses = 20;
constexpr double kMaxRestored = 0.25;  // voxels that the surface is moved to give its volume back
constexpr double kCubicMetres = 1e-9;  // in a cubic millimetre
constexpr double kAssumedWall_mm = 3.0;
constexpr double kLeastSeen = 0.2;  // of the rays, to believe what they say
constexpr double kThickestWall_mm = 12.0;
constexpr std::size_t kListedLabels = 12;

void tell(const ScanProgress& progress, ScanStep step, double fraction) {
  if (progress) {
    progress(step, fraction);
  }
}

/// Refuses a label that the mask does not have, and lists those that it has.
void requireLabel(const ScanVolume& scan, int label, const std::string& where) {
  std::map<std::int16_t, std::size_t> voxels;
  std::int16_t last = 0;
  std::size_t* count = &voxels[0];
  for (const std::int16_t value : scan.values) {
    if (value != last) {
      count = &voxels[value];
      last = value;
      if (voxels.size() > 5000) {
        break;  // not labels
      }
    }
    ++*count;
  }
  if (voxels.contains(static_cast<std::int16_t>(label)) && voxels.size() <= 5000) {
    return;
  }
  std::vector<Text> labels;
  for (const auto& [value, number] : voxels) {
    if (value != 0 && labels.size() < kListedLabels) {
      labels.emplace_back(
          Text::verbatim("%1 (%2 ml)", std::to_string(value),
                         shortNumber(0.001 * std::abs(scan.voxel_mm3()) * static_cast<double>(number))));
    }
  }
  throw Error(ErrorCode::kFileUnreadable,
              labels.empty() ? Text::tr("N07 the file has no label at all")
                             : Text::tr("N07 the file has no label %1; it has %2", std::to_string(label),
                                        listed(labels)),
              where, Text::tr("Choose one of its labels"));
}

WorkGrid gridFor(const ScanVolume& scan, const ScanRequest& request, const std::string& where) {
  const VoxelRange range = rangeOf(scan, request.box_mm, where);
  if (request.tissue == ScanTissue::kLabel) {
    const auto wanted = static_cast<std::int16_t>(request.label);
    return workGrid(
        scan, range, kMaxWorkVoxels,
        [wanted](std::int16_t value) { return value == wanted ? kWholeVoxel : 0.0F; }, 0);
  }
  return workGrid(
      scan, range, kMaxWorkVoxels, [](std::int16_t value) { return static_cast<float>(value); },
      kOutsideScan_HU);
}

/// The largest piece of a surface and whether it is one without handles.
bool isWhole(TriangleMesh& mesh) {
  MeshRepairs ignored;
  static_cast<void>(keepMainComponent(mesh, kSmallPieceShare, ignored));
  removeUnusedVertices(mesh, ignored);
  return mesh.vertices_m.size() == mesh.triangles.size() / 2 + 2;  // Euler number 2
}

/// An organ's voxels, and its surface as it was drawn on them.
struct DrawnOrgan {
  VoxelMask organ;
  TriangleMesh mesh;
  double volume_m3 = 0.0;  ///< of the shares of voxels: the surface has lost some of it in bends
};

/// Draws the organ, closing wider gaps until its surface has no handles.
DrawnOrgan drawn(const WorkGrid& grid, const VoxelMask& start, const ScanProgress& progress, double blur,
                 const std::function<OrganShares(const VoxelMask&)>& sharesOfOrgan,
                 std::vector<ScanRemark>& remarks) {
  DrawnOrgan result{start, {}, 0.0};
  for (int closing = 1; closing <= kMaxClosing; ++closing) {
    tell(progress, ScanStep::kDrawing, static_cast<double>(closing - 1) / kMaxClosing);
    result.organ = wholeOrgan(grid, start, closing);
    OrganShares shares = sharesOfOrgan(result.organ);
    result.volume_m3 = kCubicMetres * volume_mm3(shares, grid.volume);
    result.mesh = surfaceOf(std::move(shares), grid.volume, blur);
    if (isWhole(result.mesh)) {
      if (closing > 1) {
        remarks.push_back({"M16", false,
                           Text::tr("gaps of up to %1 mm were closed, so that the surface has no handles",
                                    shortNumber(2.0 * closing * grid.step_mm)),
                           2.0 * closing * grid.step_mm, ""});
      }
      break;
    }
  }
  return result;
}

/// Moves a surface outwards evenly so that it encloses a volume, as far as that is a small part of a voxel.
void restoreVolume(TriangleMesh& mesh, double volume_m3, double most_m) {
  double area_m2 = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_m[t[0]];
    area_m2 += 0.5 * norm(cross(mesh.vertices_m[t[1]] - a, mesh.vertices_m[t[2]] - a));
  }
  const double out_m = area_m2 > 0.0 ? (volume_m3 - signedVolume_m3(mesh)) / area_m2 : 0.0;
  const double moved_m = std::clamp(out_m, -most_m, most_m);
  const std::vector<Vec3> normals = vertexNormals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    mesh.vertices_m[v] += moved_m * normals[v];
  }
}

TriangleMesh finished(DrawnOrgan organ, double step_mm, const ScanProgress& progress, std::size_t& raw) {
  raw = organ.mesh.triangles.size();
  tell(progress, ScanStep::kThinning, 0.0);
  smooth(organ.mesh, kSmoothingPasses);
  TriangleMesh mesh = thinned(std::move(organ.mesh), kKeptTriangles);
  restoreVolume(mesh, organ.volume_m3, 1e-3 * kMaxRestored * step_mm);
  return mesh;
}

/// Says how thick the organ's wall is, and how far from its lumen it is looked for.
double wallReach_mm(const ScanRequest& request, ScanSurface& result) {
  if (request.wall_mm) {
    result.ownWall_mm = request.wall_mm;
    return *request.wall_mm;
  }
  if (result.wall && result.wall->seen >= kLeastSeen) {
    result.ownWall_mm = result.wall->median_mm;
    return std::min(result.wall->ninety_mm, kThickestWall_mm);
  }
  result.ownWall_mm = kAssumedWall_mm;
  result.remarks.push_back({"D18", true,
                            Text::tr("the scan does not show where the wall ends: %1 mm are assumed",
                                     shortNumber(kAssumedWall_mm)),
                            kAssumedWall_mm, Text::tr("Give its thickness with --wall")});
  return kAssumedWall_mm;
}

void tellWall(const std::optional<WallThickness>& wall, std::vector<ScanRemark>& remarks) {
  if (!wall) {
    return;
  }
  remarks.push_back(
      {"D18", false,
       Text::tr("the wall is %1 mm thick in the median, %2 to %3 mm in eight tenths, over the %4 % of the "
                "surface where its end is seen",
                shortNumber(wall->median_mm), shortNumber(wall->tenth_mm), shortNumber(wall->ninety_mm),
                shortNumber(100.0 * wall->seen)),
       wall->median_mm, ""});
}

void measureWall(const ScanVolume& scan, const TriangleMesh& lumen, const FoundPiece& found,
                 ScanSurface& result) {
  result.wallRays = wallRays(scan, lumen, found.level.level);
  result.wall = wallThickness(result.wallRays, lumen.vertices_m.size());
  tellWall(result.wall, result.remarks);
}

std::string tissueName(const ScanRequest& request) {
  switch (request.tissue) {
    case ScanTissue::kSkin:
      return ", skin";
    case ScanTissue::kGasLumen:
      return ", gas in its lumen";
    case ScanTissue::kWall:
      return ", wall";
    case ScanTissue::kLabel:
      break;
  }
  return ", label " + std::to_string(request.label);
}

/// The name of what was read, which says nothing of the patient.
std::string kindOf(const ScanRequest& request, const ScanSurface& surface) {
  const bool dicom = std::filesystem::is_directory(request.source);
  return (dicom ? "CT, " + std::to_string(surface.count[2]) + " slices" : std::string("NIfTI")) +
         tissueName(request);
}

/// A scan on its way to a surface.
struct ScanWork {
  const ScanRead& scan;
  const ScanRequest& request;
  const ScanProgress& progress;
  ScanSurface& result;
};

/// Says that somebody mended the mask.
void tellBrush(const WorkGrid& grid, const BrushWork& work, std::vector<ScanRemark>& remarks) {
  const auto millilitres = [&grid](std::size_t voxels) {
    return 0.001 * std::abs(grid.volume.voxel_mm3()) * static_cast<double>(voxels);
  };
  remarks.push_back({"D19", false,
                     Text::tr("the mask was corrected by hand: %1 ml added, %2 ml removed",
                              shortNumber(millilitres(work.added)), shortNumber(millilitres(work.erased))),
                     millilitres(work.added + work.erased), ""});
}

/// The tissue of the request as the threshold shows it and the brush mended it.
VoxelMask mended(const ScanWork& work, const WorkGrid& grid, VoxelMask mask, VoxelMask& tissue) {
  if (!work.request.brush.empty()) {
    tellBrush(grid, brushOver(grid, work.request.brush, mask, tissue), work.result.remarks);
    if (mask.voxels() == 0) {
      throw Error(ErrorCode::kFileUnreadable, Text::tr("D16 the brush took all of the organ away"), "",
                  Text::tr("Undo some of its strokes"));
    }
  }
  return mask;
}

/// Draws a lumen, whose voxels are `start`, and takes its wall with it.
OrganShares wallRound(const ScanWork& work, const WorkGrid& grid, const FoundPiece& found,
                      const VoxelMask& start) {
  const auto lumen = [&](const VoxelMask& organ) { return organShares(grid, organ, found); };
  DrawnOrgan organ = drawn(grid, start, work.progress, kSoftBlur, lumen, work.result.remarks);
  const VoxelMask whole = organ.organ;
  const TriangleMesh mesh = finished(std::move(organ), grid.step_mm, work.progress, work.result.rawTriangles);
  tell(work.progress, ScanStep::kMeasuring, 0.0);
  measureWall(work.scan.volume, mesh, found, work.result);
  return wallShares(grid, whole, wallReach_mm(work.request, work.result));
}

/// What of a scan the organ is, before its surface is drawn.
struct OrganTissue {
  FoundPiece found;
  VoxelMask start;                   ///< its voxels, gaps and holes not closed yet
  std::optional<OrganShares> outer;  ///< of an organ with its wall
};

OrganTissue tissueOf(const ScanWork& work, const WorkGrid& grid, const std::string& where) {
  FoundPiece found = foundPiece(grid, work.request, where, work.result.remarks);
  std::optional<OrganShares> outer;
  VoxelMask start = found.piece;
  if (work.request.fluid) {
    start.add(fluidBelow(grid, found.piece, where, work.result.remarks));
  }
  VoxelMask walled(grid.volume.count);
  if (work.request.tissue == ScanTissue::kWall) {
    outer = wallRound(work, grid, found, start);
    start = maskOf(*outer, grid.volume.count);
    walled = start;
  }
  start = mended(work, grid, std::move(start), outer ? walled : found.piece);
  return {std::move(found), std::move(start), std::move(outer)};
}

/// Checks a scan for a request and samples the part that is looked at.
WorkGrid beginWork(const ScanWork& work, const std::string& where) {
  const ScanVolume& volume = work.scan.volume;
  requireScanRequest(work.request);
  work.result.remarks = work.scan.remarks;
  work.result.count = volume.count;
  work.result.voxel_mm = {norm(volume.step_mm[0]), norm(volume.step_mm[1]), norm(volume.step_mm[2])};
  tell(work.progress, ScanStep::kSegmenting, 0.0);
  if (work.request.tissue == ScanTissue::kLabel) {
    requireLabel(volume, work.request.label, where);
  } else {
    requireHounsfield(volume, where);
  }
  WorkGrid grid = gridFor(volume, work.request, where);
  work.result.step_mm = grid.step_mm;
  return grid;
}

}  // namespace

ScanSurface surfaceOfScan(ScanRead scan, const ScanRequest& request, const std::string& where,
                          const ScanProgress& progress) {
  ScanSurface result;
  const ScanWork work{scan, request, progress, result};
  const WorkGrid grid = beginWork(work, where);
  const OrganTissue tissue = tissueOf(work, grid, where);
  const bool label = request.tissue == ScanTissue::kLabel;
  const auto shares = [&](const VoxelMask& organ) {
    return tissue.outer ? agreeing(*tissue.outer, organ) : organShares(grid, organ, tissue.found);
  };
  DrawnOrgan organ =
      drawn(grid, tissue.start, progress, label ? kHardBlur : kSoftBlur, shares, result.remarks);
  const VoxelMask whole = organ.organ;
  result.mesh = finished(std::move(organ), grid.step_mm, progress, result.rawTriangles);
  if (!label) {
    result.level_HU = tissue.found.level.level;
  }
  if (request.tissue == ScanTissue::kGasLumen) {
    tell(progress, ScanStep::kMeasuring, 0.0);
    measureWall(scan.volume, result.mesh, tissue.found, result);
  }
  if (const auto cut = cutOff(grid, whole)) {
    result.remarks.push_back(*cut);
  }
  return result;
}

OrganVoxels organVoxels(const ScanRead& scan, const ScanRequest& request, const std::string& where,
                        const ScanProgress& progress) {
  ScanSurface result;
  const ScanWork work{scan, request, progress, result};
  WorkGrid grid = beginWork(work, where);
  const OrganTissue tissue = tissueOf(work, grid, where);
  VoxelMask organ = wholeOrgan(grid, tissue.start, 1);
  if (const auto cut = cutOff(grid, organ)) {
    result.remarks.push_back(*cut);
  }
  return {std::move(grid), std::move(organ), std::move(result.remarks)};
}

ScanRead readScan(const ScanRequest& request) {
  const std::string where = request.source.string();
  if (std::filesystem::is_directory(request.source)) {
    return readDicomSeries({request.source, request.series, request.resample});
  }
  if (!isNiftiFile(request.source)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("N01 this kind of scan cannot be read"), where,
                Text::tr("Give a folder of DICOM files, or a NIfTI file (.nii, .nii.gz)"));
  }
  return readNifti(request.source);
}

ScanSurface surfaceOfScan(const ScanRequest& request, const ScanProgress& progress) {
  tell(progress, ScanStep::kReading, 0.0);
  requireScanRequest(request);
  const std::string where = request.source.string();
  if (request.tissue == ScanTissue::kLabel && std::filesystem::is_directory(request.source)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("N07 a CT has no labels"), where,
                Text::tr("Give the label mask, a NIfTI file"));
  }
  ScanSurface surface = surfaceOfScan(readScan(request), request, where, progress);
  surface.kind = kindOf(request, surface);
  return surface;
}

}  // namespace torsio
