// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/scan_preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "sim/imaging/surface/scan_surface.h"

namespace torsio {

namespace {

double component(const Vec3& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// How the axes of a preview lie in its scan.
struct Turned {
  std::array<std::size_t, 3> axis{};     ///< of the scan, for the left, the back, the head
  std::array<bool, 3> backwards{};       ///< along it
  std::array<std::size_t, 3> samples{};  ///< along it
  /// The scan's voxel at the middle of a sample, with a fraction.
  [[nodiscard]] double voxelOf(std::size_t along, std::size_t sample, const ScanVolume& scan) const {
    const double ratio = static_cast<double>(scan.count[axis[along]]) / static_cast<double>(samples[along]);
    const double at = (static_cast<double>(sample) + 0.5) * ratio - 0.5;
    return backwards[along] ? static_cast<double>(scan.count[axis[along]] - 1) - at : at;
  }
};

/// The scan's axes in the order of the patient's, each once: of the six orders the one that agrees best.
Turned turnedTo(const ScanVolume& scan, double mostVoxels) {
  std::array<std::size_t, 3> order{0, 1, 2};
  Turned best;
  double agreement = -1.0;
  do {
    double sum = 0.0;
    for (std::size_t along = 0; along < 3; ++along) {
      const Vec3& step = scan.step_mm[order[along]];
      sum += std::abs(component(step, along)) / norm(step);
    }
    if (sum > agreement) {
      agreement = sum;
      best.axis = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  double least_mm = 1e9;
  double product_mm3 = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double voxel_mm = norm(scan.step_mm[axis]);
    least_mm = std::min(least_mm, voxel_mm);
    product_mm3 *= voxel_mm * static_cast<double>(scan.count[axis]);
  }
  const double step_mm = std::max(least_mm, std::cbrt(product_mm3 / mostVoxels));
  for (std::size_t along = 0; along < 3; ++along) {
    const std::size_t axis = best.axis[along];
    best.backwards[along] = component(scan.step_mm[axis], along) < 0.0;
    const double side_mm = norm(scan.step_mm[axis]) * static_cast<double>(scan.count[axis]);
    best.samples[along] = static_cast<std::size_t>(std::max(1.0, std::floor(side_mm / step_mm)));
  }
  return best;
}

/// For each sample of a preview along each of its axes: a voxel of another grid along the same axis.
using VoxelTables = std::array<std::vector<std::size_t>, 3>;

/// Calls `visit(n, ijk)` for each voxel of a preview with its place and the voxel of the tables.
template <typename Visit>
void eachSample(const Turned& turned, const VoxelTables& tables, const Visit& visit) {
  std::size_t n = 0;
  std::array<std::size_t, 3> voxel{};
  for (std::size_t z = 0; z < turned.samples[2]; ++z) {
    voxel[turned.axis[2]] = tables[2][z];
    for (std::size_t y = 0; y < turned.samples[1]; ++y) {
      voxel[turned.axis[1]] = tables[1][y];
      for (std::size_t x = 0; x < turned.samples[0]; ++x, ++n) {
        voxel[turned.axis[0]] = tables[0][x];
        visit(n, voxel);
      }
    }
  }
}

void sampleValues(const ScanVolume& scan, const Turned& turned, ScanVolume& preview) {
  Vec3 first{};
  VoxelTables tables;
  for (std::size_t along = 0; along < 3; ++along) {
    const std::size_t axis = turned.axis[along];
    for (std::size_t s = 0; s < turned.samples[along]; ++s) {
      const double at = std::floor(turned.voxelOf(along, s, scan) + 0.5);
      tables[along].push_back(
          static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(scan.count[axis] - 1))));
    }
    const double ratio = static_cast<double>(scan.count[axis]) / static_cast<double>(turned.samples[along]);
    preview.count[along] = turned.samples[along];
    preview.step_mm[along] = (turned.backwards[along] ? -ratio : ratio) * scan.step_mm[axis];
    (axis == 0 ? first.x : axis == 1 ? first.y : first.z) = turned.voxelOf(along, 0, scan);
  }
  preview.origin_mm = scan.place_mm(first);
  preview.values.resize(turned.samples[0] * turned.samples[1] * turned.samples[2]);
  eachSample(turned, tables, [&](std::size_t n, const std::array<std::size_t, 3>& voxel) {
    preview.values[n] = scan.values[scan.index(voxel[0], voxel[1], voxel[2])];
  });
}

/// The work grid's axes are the scan's.
void sampleOrgan(const ScanVolume& scan, const Turned& turned, const OrganVoxels& found,
                 ScanPreview& preview) {
  const ScanVolume& grid = found.grid.volume;
  VoxelTables tables;
  for (std::size_t along = 0; along < 3; ++along) {
    const std::size_t axis = turned.axis[along];
    for (std::size_t s = 0; s < turned.samples[along]; ++s) {
      Vec3 ijk{};
      (axis == 0 ? ijk.x : axis == 1 ? ijk.y : ijk.z) = turned.voxelOf(along, s, scan);
      const double at = std::floor(component(grid.voxelAt(scan.place_mm(ijk)), axis) + 0.5);
      const bool inside = at >= 0.0 && at < static_cast<double>(grid.count[axis]);
      tables[along].push_back(inside ? static_cast<std::size_t>(at) : 0);  // 0: the margin, never an organ
    }
  }
  preview.within.resize(preview.volume.values.size());
  eachSample(turned, tables, [&](std::size_t n, const std::array<std::size_t, 3>& voxel) {
    preview.within[n] = found.organ.at(voxel[0], voxel[1], voxel[2]) ? 1 : 0;
  });
  constexpr double kMillilitre_mm3 = 1000.0;
  preview.volume_ml =
      std::abs(grid.voxel_mm3()) * static_cast<double>(found.organ.voxels()) / kMillilitre_mm3;
}

}  // namespace

ScanPreview previewOfScan(const ScanRead& scan, const ScanRequest& request, bool find, double mostVoxels,
                          const ScanProgress& progress) {
  ScanPreview preview;
  const Turned turned = turnedTo(scan.volume, mostVoxels);
  sampleValues(scan.volume, turned, preview.volume);
  preview.remarks = scan.remarks;
  if (find) {
    const OrganVoxels found = organVoxels(scan, request, request.source.string(), progress);
    sampleOrgan(scan.volume, turned, found, preview);
    preview.remarks = found.remarks;
  }
  return preview;
}

ScanPreview previewOfScan(const ScanRequest& request, bool find, const ScanProgress& progress) {
  if (progress) {
    progress(ScanStep::kReading, 0.0);
  }
  const ScanRead scan = readScan(request);
  ScanPreview preview = previewOfScan(scan, request, find, kPreviewVoxels, progress);
  preview.kind = std::filesystem::is_directory(request.source)
                     ? "CT, " + std::to_string(scan.volume.count[2]) + " slices"
                     : "NIfTI";
  return preview;
}

}  // namespace torsio
