// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/scan/scan_volume.h"

#include <cmath>

#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kLeastShare = 0.001;  // of the voxels that have to be air, and soft tissue
constexpr std::int16_t kAirBelow_HU = -800;
constexpr std::int16_t kSoftFrom_HU = -200;
constexpr std::int16_t kSoftTo_HU = 200;

std::string inGigabytes(double bytes) {
  const auto tenths = std::lround(bytes / 1e8);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

Vec3 ScanVolume::place_mm(const Vec3& ijk) const noexcept {
  return origin_mm + ijk.x * step_mm[0] + ijk.y * step_mm[1] + ijk.z * step_mm[2];
}

double ScanVolume::voxel_mm3() const noexcept {
  return dot(step_mm[0], cross(step_mm[1], step_mm[2]));
}

Vec3 ScanVolume::voxelAt(const Vec3& at_mm) const noexcept {
  const Vec3 from = at_mm - origin_mm;
  const double all = voxel_mm3();
  return {dot(from, cross(step_mm[1], step_mm[2])) / all, dot(from, cross(step_mm[2], step_mm[0])) / all,
          dot(from, cross(step_mm[0], step_mm[1])) / all};
}

void requireHounsfield(const ScanVolume& volume, const std::string& where) {
  std::size_t air = 0;
  std::size_t soft = 0;
  for (const std::int16_t value : volume.values) {
    air += value < kAirBelow_HU ? 1 : 0;
    soft += value >= kSoftFrom_HU && value <= kSoftTo_HU ? 1 : 0;
  }
  const auto all = static_cast<double>(volume.values.size());
  const bool enoughAir = static_cast<double>(air) >= kLeastShare * all;
  if (enoughAir && static_cast<double>(soft) >= kLeastShare * all) {
    return;
  }
  const Text missing =
      enoughAir ? Text::tr("soft tissue between -200 and 200 HU") : Text::tr("air near -1000 HU");
  throw Error(ErrorCode::kFileUnreadable,
              Text::tr("D13 the values are not those of a CT: there is no %1", missing), where,
              Text::tr("Give a CT in Hounsfield units, or a label mask with --tissue label N"));
}

void requireSize(const std::array<std::size_t, 3>& count, const std::string& where) {
  const double voxels =
      static_cast<double>(count[0]) * static_cast<double>(count[1]) * static_cast<double>(count[2]);
  if (voxels > static_cast<double>(kMaxVoxels)) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("D15 the scan is too large: %1 x %2 x %3 voxels are %4 GB, at most %5 GB are read",
                         std::to_string(count[0]), std::to_string(count[1]), std::to_string(count[2]),
                         inGigabytes(voxels * sizeof(std::int16_t)),
                         inGigabytes(static_cast<double>(kMaxVoxels) * sizeof(std::int16_t))),
                where, Text::tr("Crop the scan, or export it with larger voxels"));
  }
}

}  // namespace torsio
