// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/scan_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/imaging/surface/work_grid.h"

namespace torsio {

namespace {

constexpr double kFullRow = 0.98;      // of the voxels of a row, from side to side
constexpr double kFullSlices = 0.9;    // of the slices
constexpr double kEmptyRow = 0.5;      // behind the table
constexpr double kThickest_mm = 60.0;  // of a table

/// Shares of a layer: rows that are full, and voxels that are set.
struct LayerShares {
  double fullRows = 0.0;
  double set = 0.0;
};

LayerShares sharesOfLayer(const WorkGrid& grid, const VoxelMask& within, std::size_t axis,
                          std::size_t layer) {
  const std::size_t across = wayNearest(grid.volume, {1, 0, 0}).axis;
  const std::size_t slices = 3 - axis - across;
  std::size_t full = 0;
  std::size_t all = 0;
  std::array<std::size_t, 3> at{};
  at[axis] = layer;
  const std::size_t width = grid.high()[across] - grid.low()[across];
  const std::size_t rows = grid.high()[slices] - grid.low()[slices];
  for (std::size_t s = grid.low()[slices]; s < grid.high()[slices]; ++s) {
    at[slices] = s;
    std::size_t set = 0;
    for (std::size_t x = grid.low()[across]; x < grid.high()[across]; ++x) {
      at[across] = x;
      set += within.at(at[0], at[1], at[2]) ? 1U : 0U;
    }
    all += set;
    full += static_cast<double>(set) >= kFullRow * static_cast<double>(width) ? 1U : 0U;
  }
  return {static_cast<double>(full) / static_cast<double>(rows),
          static_cast<double>(all) / static_cast<double>(rows * width)};
}

}  // namespace

std::optional<TablePlane> tableIn(const WorkGrid& grid, const VoxelMask& within) {
  const GridWay back = wayNearest(grid.volume, {0, 1, 0});
  const std::size_t axis = back.axis;
  if (wayNearest(grid.volume, {1, 0, 0}).axis == axis) {
    return std::nullopt;  // slices that lie askew
  }
  const std::size_t low = grid.low()[axis];
  const std::size_t high = grid.high()[axis];
  const auto deep = static_cast<std::size_t>(std::ceil(kThickest_mm / norm(grid.volume.step_mm[axis])));
  for (const bool prone : {false, true}) {
    const bool backwards = back.backwards != prone;
    const auto layerAt = [&](std::size_t n) { return backwards ? high - 1 - n : low + n; };
    const std::size_t layers = high - low;
    for (std::size_t n = layers / 4; n < layers; ++n) {
      if (sharesOfLayer(grid, within, axis, layerAt(n)).fullRows < kFullSlices) {
        continue;
      }
      for (std::size_t behind = n + 1; behind < std::min(layers, n + 1 + deep); ++behind) {
        if (sharesOfLayer(grid, within, axis, layerAt(behind)).set < kEmptyRow) {
          Vec3 voxel{};
          const double top = static_cast<double>(layerAt(n)) + (backwards ? 0.5 : -0.5);
          (axis == 0 ? voxel.x : axis == 1 ? voxel.y : voxel.z) = top;
          return TablePlane{axis, layerAt(n), backwards, grid.volume.place_mm(voxel).y};
        }
      }
      break;  // it goes on to the border: no table, but a scan of a part
    }
  }
  return std::nullopt;
}

void removeTable(const WorkGrid& grid, const TablePlane& table, VoxelMask& within) {
  VoxelMask behind(within.count());
  for (std::size_t z = 0; z < grid.volume.count[2]; ++z) {
    for (std::size_t y = 0; y < grid.volume.count[1]; ++y) {
      for (std::size_t x = 0; x < grid.volume.count[0]; ++x) {
        const std::array<std::size_t, 3> at{x, y, z};
        const std::size_t layer = at[table.axis];
        if (table.backwards ? layer <= table.first : layer >= table.first) {
          behind.set(x, y, z);
        }
      }
    }
  }
  within.remove(behind);
}

}  // namespace torsio
