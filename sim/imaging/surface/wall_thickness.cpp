// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/wall_thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace torsio {

namespace {

constexpr double kLongestRay_mm = 10.0;
constexpr double kMaxSlope_mm = 3.0;     // from the end of the gas to soft tissue: blurred by the scanner
constexpr double kStepShare = 0.25;      // of the scan's smallest voxel
constexpr double kSoftToFat_HU = 140.0;  // soft tissue 40, fat -100
constexpr double kFarAway = 1e9;
constexpr double kMillimetresPerMetre = 1e3;

/// The scan's value at a place, between eight voxels; none outside.
std::optional<double> valueAt(const ScanVolume& scan, const Vec3& place_mm) {
  const Vec3 at = scan.voxelAt(place_mm);
  const std::array<double, 3> along{at.x, at.y, at.z};
  std::array<std::size_t, 3> first{};
  std::array<double, 3> part{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(along[axis] >= 0.0 && along[axis] <= static_cast<double>(scan.count[axis] - 1))) {
      return std::nullopt;
    }
    first[axis] = std::min(static_cast<std::size_t>(along[axis]), scan.count[axis] - 2);
    part[axis] = along[axis] - static_cast<double>(first[axis]);
  }
  double sum = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const std::array<std::size_t, 3> step{corner & 1U, (corner >> 1U) & 1U, corner >> 2U};
    double weight = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      weight *= step[axis] == 1 ? part[axis] : 1.0 - part[axis];
    }
    sum += weight * scan.values[scan.index(first[0] + step[0], first[1] + step[1], first[2] + step[2])];
  }
  return sum;
}

/// Length of the soft tissue along a ray that begins in gas; none where no end of it is seen.
std::optional<double> thicknessAlong(const ScanVolume& scan, const Vec3& from_mm, const Vec3& direction,
                                     double level_HU, double step_mm) {
  const int before = static_cast<int>(kMaxSlope_mm / step_mm);
  const int steps = static_cast<int>(kLongestRay_mm / step_mm);
  std::optional<double> gasEnds_mm;
  bool soft = false;
  double last_HU = kFarAway;
  for (int n = -before; n <= steps; ++n) {
    const double at_mm = n * step_mm;
    const std::optional<double> value = valueAt(scan, from_mm + at_mm * direction);
    if (!value) {
      return std::nullopt;
    }
    const double value_HU = *value;
    // Between the last step and this one, where the value passes `wanted`.
    const auto passed_mm = [&](double wanted) {
      return at_mm - step_mm * (value_HU - wanted) / (value_HU - last_HU);
    };
    if (!gasEnds_mm && last_HU <= level_HU && value_HU > level_HU) {
      gasEnds_mm = passed_mm(level_HU);
    }
    if (gasEnds_mm && !soft && at_mm > *gasEnds_mm + kMaxSlope_mm) {
      return std::nullopt;  // thinner than the scan can show
    }
    if (gasEnds_mm && soft && value_HU < kWallEnd_HU) {
      return passed_mm(kWallEnd_HU) - *gasEnds_mm;
    }
    soft = soft || (gasEnds_mm && value_HU > kWallEnd_HU);
    last_HU = value_HU;
  }
  return std::nullopt;
}

/// Squared distances of a line of samples to the nearest of those with an offset (Felzenszwalb 2012).
void distancesAlong(std::vector<float>& line, std::vector<std::size_t>& places, std::vector<double>& borders,
                    std::vector<float>& result) {
  const auto squared = [](std::size_t i) { return static_cast<double>(i) * static_cast<double>(i); };
  std::size_t last = 0;
  places[0] = 0;
  borders[0] = -kFarAway;
  for (std::size_t q = 1; q < line.size(); ++q) {
    const auto meets = [&](std::size_t p) {
      return (static_cast<double>(line[q]) + squared(q) - static_cast<double>(line[p]) - squared(p)) /
             (2.0 * static_cast<double>(q - p));
    };
    double border = meets(places[last]);
    while (last > 0 && border <= borders[last]) {
      border = meets(places[--last]);
    }
    places[++last] = q;
    borders[last] = border;
  }
  std::size_t parabola = 0;
  for (std::size_t q = 0; q < line.size(); ++q) {
    while (parabola < last && borders[parabola + 1] < static_cast<double>(q)) {
      ++parabola;
    }
    const double away = static_cast<double>(q) - static_cast<double>(places[parabola]);
    result[q] = static_cast<float>(away * away + static_cast<double>(line[places[parabola]]));
  }
  std::swap(line, result);
}

/// Turns 0 and far away into squared distances, in voxels.
void spreadDistances(std::vector<float>& squares, const std::array<std::size_t, 3>& count) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t stride = axis == 0 ? 1 : axis == 1 ? count[0] : count[0] * count[1];
    const std::size_t length = count[axis];
    std::vector<float> line(length);
    std::vector<float> spare(length);
    std::vector<std::size_t> places(length);
    std::vector<double> borders(length);
    for (std::size_t n = 0; n < squares.size() / length; ++n) {
      const std::size_t start = n / stride * stride * length + n % stride;
      for (std::size_t i = 0; i < length; ++i) {
        line[i] = squares[start + i * stride];
      }
      distancesAlong(line, places, borders, spare);
      for (std::size_t i = 0; i < length; ++i) {
        squares[start + i * stride] = line[i];
      }
    }
  }
}

}  // namespace

std::vector<WallRay> wallRays(const ScanVolume& scan, const TriangleMesh& lumen, double level_HU) {
  for (const std::size_t side : scan.count) {
    if (side < 2) {
      return {};
    }
  }
  const double step_mm =
      kStepShare * std::min({norm(scan.step_mm[0]), norm(scan.step_mm[1]), norm(scan.step_mm[2])});
  const std::vector<Vec3> normals = vertexNormals(lumen);
  std::vector<WallRay> rays;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3 from_mm = kMillimetresPerMetre * lumen.vertices_m[v];
    if (const auto thickness_mm = thicknessAlong(scan, from_mm, normals[v], level_HU, step_mm)) {
      rays.push_back({from_mm, *thickness_mm});
    }
  }
  return rays;
}

std::optional<WallThickness> wallThickness(const std::vector<WallRay>& rays, std::size_t all) {
  if (rays.empty()) {
    return std::nullopt;
  }
  std::vector<double> thicknesses_mm;
  for (const WallRay& ray : rays) {
    thicknesses_mm.push_back(ray.thickness_mm);
  }
  std::sort(thicknesses_mm.begin(), thicknesses_mm.end());
  const auto quantile = [&thicknesses_mm](double share) {
    return thicknesses_mm[static_cast<std::size_t>(share * static_cast<double>(thicknesses_mm.size() - 1))];
  };
  return WallThickness{quantile(0.5), quantile(0.1), quantile(0.9),
                       static_cast<double>(rays.size()) / static_cast<double>(all)};
}

OrganShares wallShares(const WorkGrid& grid, const VoxelMask& lumen, double wall_mm) {
  const double reach = wall_mm / grid.step_mm;  // in voxels
  // Everything that could be wall, for the room that it needs.
  VoxelMask room = lumen.grown(static_cast<int>(std::ceil(reach)) + 1);
  const VoxelMask scan = scannedVoxels(grid);
  room.keepOnly(scan);
  OrganShares part = emptyShares(room);
  eachVoxelOf(part, [&](std::size_t n, std::size_t x, std::size_t y, std::size_t z) {
    part.shares[n] = lumen.at(x, y, z) ? 0.0F : 1e9F;
  });
  spreadDistances(part.shares, part.count);
  eachVoxelOf(part, [&](std::size_t n, std::size_t x, std::size_t y, std::size_t z) {
    // Its border lies half a voxel beyond the middle of the lumen's last voxel.
    const double away = std::sqrt(static_cast<double>(part.shares[n]));
    const double near = std::clamp(1.0 + reach - away, 0.0, 1.0);
    const double soft =
        away <= 1.5
            ? 1.0
            : std::clamp(0.5 + (grid.volume.values[grid.volume.index(x, y, z)] - kWallEnd_HU) / kSoftToFat_HU,
                         0.0, 1.0);
    part.shares[n] = scan.at(x, y, z) ? static_cast<float>(std::min(near, soft)) : 0.0F;
  });
  return part;
}

}  // namespace torsio
