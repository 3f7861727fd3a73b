// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/fluid_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

namespace {

constexpr long kLevelAway = 2;       // voxels from the last gas: the surface is blurred over one
constexpr long kLevelDepth = 4;      // voxels that are taken for fluid there
constexpr double kLeastFlat = 0.15;  // of the columns of gas that have to end at the level
constexpr double kLeastFluid_HU = -50.0;
constexpr double kFat_HU = -100.0;
constexpr double kSoftFrom_HU = 20.0;
constexpr double kSoftTo_HU = 100.0;
constexpr double kDefaultSoft_HU = 45.0;
constexpr double kLeastContrast_HU = 15.0;
constexpr double kMaxFilled_ml = 3000.0;
constexpr std::size_t kMaxFluidBorders = 3;

/// Columns of a grid along a way; the farther along it, the lower.
class Columns {
 public:
  Columns(const WorkGrid& grid, const GridWay& way)
      : grid_(grid), way_(way), across_((way.axis + 1) % 3), along_((way.axis + 2) % 3) {}

  [[nodiscard]] std::size_t number() const { return count(across_) * count(along_); }
  [[nodiscard]] long depth() const { return static_cast<long>(count(way_.axis)); }
  /// The voxel of a column at a depth.
  [[nodiscard]] std::array<std::size_t, 3> voxel(std::size_t column, long deep) const {
    std::array<std::size_t, 3> at{};
    at[across_] = column % count(across_);
    at[along_] = column / count(across_);
    at[way_.axis] = static_cast<std::size_t>(way_.backwards ? depth() - 1 - deep : deep);
    return at;
  }
  [[nodiscard]] double value(std::size_t column, long deep) const {
    const auto at = voxel(column, deep);
    return grid_.volume.values[grid_.volume.index(at[0], at[1], at[2])];
  }
  [[nodiscard]] long depthOf(const std::array<std::size_t, 3>& at) const {
    const auto place = static_cast<long>(at[way_.axis]);
    return way_.backwards ? depth() - 1 - place : place;
  }

 private:
  [[nodiscard]] std::size_t count(std::size_t axis) const { return grid_.volume.count[axis]; }
  const WorkGrid& grid_;
  GridWay way_;
  std::size_t across_;
  std::size_t along_;
};

/// Where the gas ends in each column; -1 where there is none, or where it does not end at fluid.
struct GasEnds {
  std::vector<long> depths;
  std::size_t columns = 0;  ///< with gas in them
  long level = 0;           ///< at which most of them end
  double flat = 0.0;        ///< share of the columns that end there
};

bool mayBeFluid(const Columns& columns, std::size_t column, long deep) {
  for (long away = kLevelAway; away < kLevelAway + kLevelDepth; ++away) {
    if (deep + away >= columns.depth() || columns.value(column, deep + away) < kLeastFluid_HU) {
      return false;
    }
  }
  return true;
}

GasEnds gasEnds(const Columns& columns, const VoxelMask& gas) {
  GasEnds ends;
  ends.depths.assign(columns.number(), -1);
  std::vector<std::size_t> atDepth(static_cast<std::size_t>(columns.depth()) + 2, 0);
  for (std::size_t column = 0; column < columns.number(); ++column) {
    long last = -1;
    for (long deep = 0; deep < columns.depth(); ++deep) {
      const auto at = columns.voxel(column, deep);
      last = gas.at(at[0], at[1], at[2]) ? deep : last;
    }
    if (last < 0) {
      continue;
    }
    ++ends.columns;
    if (mayBeFluid(columns, column, last)) {
      ends.depths[column] = last;
      ++atDepth[static_cast<std::size_t>(last)];
    }
  }
  std::size_t most = 0;
  for (std::size_t deep = 1; deep + 1 < atDepth.size(); ++deep) {
    const std::size_t near = atDepth[deep - 1] + atDepth[deep] + atDepth[deep + 1];
    if (near > most) {
      most = near;
      ends.level = static_cast<long>(deep);
    }
  }
  ends.flat = ends.columns > 0 ? static_cast<double>(most) / static_cast<double>(ends.columns) : 0.0;
  return ends;
}

double medianOf(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Means over 27 voxels.
std::vector<float> smoothed(const ScanVolume& volume) {
  std::vector<float> values(volume.values.begin(), volume.values.end());
  std::vector<float> line;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t stride = axis == 0   ? 1
                               : axis == 1 ? volume.count[0]
                                           : volume.count[0] * volume.count[1];
    const std::size_t length = volume.count[axis];
    line.resize(length);
    for (std::size_t n = 0; n < values.size() / length; ++n) {
      const std::size_t start = n / stride * stride * length + n % stride;
      for (std::size_t i = 0; i < length; ++i) {
        line[i] = values[start + i * stride];
      }
      for (std::size_t i = 1; i + 1 < length; ++i) {
        values[start + i * stride] = (line[i - 1] + line[i] + line[i + 1]) / 3.0F;
      }
    }
  }
  return values;
}

/// Between which values a fluid lies.
struct FluidRange {
  double fluid = 0.0;
  double from = 0.0;
  double to = 0.0;
  [[nodiscard]] bool holds(double value) const noexcept { return value > from && value < to; }
};

[[noreturn]] void refuseFluid(const Text& what, const std::string& where) {
  throw Error(ErrorCode::kFileUnreadable, what, where,
              Text::tr("Leave out --fluid and correct the mask with the brush, or give a label mask"));
}

FluidRange fluidRange(const Columns& columns, const GasEnds& ends, const VoxelMask& gas,
                      const std::string& where) {
  std::vector<double> fluid;
  for (std::size_t column = 0; column < columns.number(); ++column) {
    if (ends.depths[column] >= 0 && std::abs(ends.depths[column] - ends.level) <= 1) {
      for (long away = kLevelAway; away < kLevelAway + kLevelDepth; ++away) {
        fluid.push_back(columns.value(column, ends.depths[column] + away));
      }
    }
  }
  // The wall round the gas, above the level.
  VoxelMask around = gas.grown(3);
  around.remove(gas.grown(1));
  std::vector<double> wall;
  for (std::size_t column = 0; column < columns.number(); ++column) {
    for (long deep = 0; deep < ends.level - kLevelAway; ++deep) {
      const auto at = columns.voxel(column, deep);
      const double value = around.at(at[0], at[1], at[2]) ? columns.value(column, deep) : kFat_HU;
      if (value > kSoftFrom_HU && value < kSoftTo_HU) {
        wall.push_back(value);
      }
    }
  }
  FluidRange range;
  range.fluid = medianOf(fluid);
  const double soft = wall.empty() ? kDefaultSoft_HU : medianOf(wall);
  if (std::abs(soft - range.fluid) < kLeastContrast_HU) {
    refuseFluid(Text::tr("D16 the fluid below the gas (%1 HU) is as dense as the wall (%2 HU)",
                         shortNumber(range.fluid), shortNumber(soft)),
                where);
  }
  const double border = 0.5 * (soft + range.fluid);
  constexpr double kMetal_HU = 1e6;
  range.from = range.fluid > soft ? border : 0.5 * (range.fluid + kFat_HU);
  range.to = range.fluid > soft ? kMetal_HU : border;
  return range;
}

/// What has the density of the fluid below the level.
VoxelMask mayHold(const Columns& columns, const GasEnds& ends, const WorkGrid& grid,
                  const FluidRange& range) {
  const std::vector<float> mean = smoothed(grid.volume);
  return scannedWhere(grid, [&](std::size_t x, std::size_t y, std::size_t z) {
    return columns.depthOf({x, y, z}) >= ends.level + kLevelAway &&
           range.holds(static_cast<double>(mean[grid.volume.index(x, y, z)]));
  });
}

/// The piece of the fluid below most of the level, with what lies between it and the gas.
VoxelMask filledDown(const Columns& columns, const GasEnds& ends, const WorkGrid& grid,
                     const VoxelMask& within, const std::string& where) {
  const VoxelMask core = within.shrunk(1);
  const MaskPieces pieces(core, grid.low(), grid.high());
  std::vector<std::size_t> below(pieces.list().size() + 1, 0);
  for (std::size_t column = 0; column < columns.number(); ++column) {
    if (ends.depths[column] >= 0 && std::abs(ends.depths[column] - ends.level) <= 1) {
      const auto at = columns.voxel(column, ends.level + kLevelAway + 2);
      ++below[pieces.at(at[0], at[1], at[2])];
    }
  }
  below.pop_back();
  const auto most = std::max_element(below.begin(), below.end());
  if (most == below.end() || *most == 0) {
    refuseFluid(Text::tr("D16 no fluid was found below the level at which the gas ends"), where);
  }
  const MaskPiece& piece = pieces.list()[static_cast<std::size_t>(most - below.begin())];
  if (static_cast<std::size_t>(std::count(piece.atBorder.begin(), piece.atBorder.end(), true)) >
      kMaxFluidBorders) {
    refuseFluid(Text::tr("D16 the fluid leaks: it reaches the borders of the scan"), where);
  }
  VoxelMask fluid = pieces.mask(static_cast<std::size_t>(most - below.begin())).grown(2);
  fluid.keepOnly(within);
  for (std::size_t column = 0; column < columns.number(); ++column) {
    const long from = ends.depths[column];
    if (from < 0 || std::abs(from - ends.level) > 1) {
      continue;
    }
    for (long deep = from + 1; deep < ends.level + kLevelAway + 1; ++deep) {
      const auto at = columns.voxel(column, deep);
      fluid.set(at[0], at[1], at[2]);
    }
  }
  return fluid;
}

Text sideOf(std::size_t direction) {
  switch (direction) {
    case 0:
      return Text::tr("the back");
    case 1:
      return Text::tr("the front");
    case 2:
      return Text::tr("the left");
    default:
      return Text::tr("the right");
  }
}

}  // namespace

VoxelMask fluidBelow(const WorkGrid& grid, const VoxelMask& gas, const std::string& where,
                     std::vector<ScanRemark>& remarks) {
  const std::array<Vec3, 4> downwards{Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}};
  std::size_t best = 0;
  GasEnds ends;
  for (std::size_t n = 0; n < downwards.size(); ++n) {
    GasEnds one = gasEnds(Columns(grid, wayNearest(grid.volume, downwards[n])), gas);
    if (one.flat > ends.flat) {
      ends = std::move(one);
      best = n;
    }
  }
  if (!(ends.flat >= kLeastFlat)) {
    refuseFluid(Text::tr("D16 the gas has no flat lower surface: there is no fluid below it"), where);
  }
  const Columns columns(grid, wayNearest(grid.volume, downwards[best]));
  const FluidRange range = fluidRange(columns, ends, gas, where);
  VoxelMask fluid = filledDown(columns, ends, grid, mayHold(columns, ends, grid, range), where);
  const double voxel_ml = 0.001 * std::abs(grid.volume.voxel_mm3());
  const double fluid_ml = voxel_ml * static_cast<double>(fluid.voxels());
  if (fluid_ml + voxel_ml * static_cast<double>(gas.voxels()) > kMaxFilled_ml) {
    refuseFluid(Text::tr("D16 the fluid leaks: with the gas it fills %1 ml, a stomach holds at most %2 ml",
                         shortNumber(fluid_ml + voxel_ml * static_cast<double>(gas.voxels())),
                         shortNumber(kMaxFilled_ml)),
                where);
  }
  remarks.push_back({"D20", true,
                     Text::tr("%1 ml of fluid (%2 HU) below the gas, towards %3, were joined to it",
                              shortNumber(fluid_ml), shortNumber(range.fluid), sideOf(best)),
                     fluid_ml, Text::tr("Check the mask over the slices")});
  return fluid;
}

}  // namespace torsio
