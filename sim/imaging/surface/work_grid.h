// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

#include "sim/core/vec3.h"
#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

/// A part of a scan on voxels that are nearly cubes, with a margin of air round it.
struct WorkGrid {
  static constexpr std::size_t kMargin = 6;

  ScanVolume volume;
  double step_mm = 1.0;  ///< mean side of a voxel

  /// The first voxel of the scan along each axis, and the first behind it.
  [[nodiscard]] std::array<std::size_t, 3> low() const noexcept { return {kMargin, kMargin, kMargin}; }
  [[nodiscard]] std::array<std::size_t, 3> high() const noexcept {
    return {volume.count[0] - kMargin, volume.count[1] - kMargin, volume.count[2] - kMargin};
  }
};

/// Two opposite corners of a box along the patient's axes, millimetres, LPS.
using ScanBox = std::array<Vec3, 2>;

/// Voxels of a scan that a box takes in, [first, behind the last) along each axis.
struct VoxelRange {
  std::array<std::size_t, 3> low{};
  std::array<std::size_t, 3> high{};
};

/// Returns the voxels of a box, or of the whole scan. Throws Error{kFileUnreadable}, D16, for a box beside
/// the scan.
[[nodiscard]] VoxelRange rangeOf(const ScanVolume& scan, const std::optional<ScanBox>& box,
                                 const std::string& where);

/// Samples a part of a scan anew: voxels as large as the scan's smallest side, larger where there would be
/// more than `mostVoxels` of them. Each takes the mean of what it covers (between voxels of the scan that are
/// larger: what lies between their middles); `valueOf` says what a value of the scan counts. The margin holds
/// `outside`.
[[nodiscard]] WorkGrid workGrid(const ScanVolume& scan, const VoxelRange& range, double mostVoxels,
                                const std::function<float(std::int16_t)>& valueOf, std::int16_t outside);

/// A direction along an axis of a grid.
struct GridWay {
  std::size_t axis = 0;
  bool backwards = false;  ///< towards smaller numbers of voxels
};

/// Returns the direction of a grid that is nearest to one of the patient's.
[[nodiscard]] inline GridWay wayNearest(const ScanVolume& grid, const Vec3& direction) {
  GridWay best;
  double most = -1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = dot(grid.step_mm[axis], direction) / norm(grid.step_mm[axis]);
    if (std::abs(along) > most) {
      most = std::abs(along);
      best = {axis, along < 0.0};
    }
  }
  return best;
}

}  // namespace torsio
