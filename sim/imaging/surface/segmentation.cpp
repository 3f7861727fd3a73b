// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/segmentation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/core/text.h"
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

constexpr double kSkin_HU = -400.0;  // half way between air and soft tissue, before it is measured
constexpr double kGas_HU = -400.0;
constexpr double kMaxCorrection_HU = 200.0;  // that measuring may make
constexpr double kMaxLumen_ml = 3000.0;
constexpr std::size_t kMaxBorders = 3;
constexpr double kAlike = 0.25;       // of the largest piece: there is a choice to make
constexpr double kSmallPiece = 0.01;  // of the largest piece: not worth telling
constexpr std::size_t kListedPieces = 5;
constexpr int kSeedReach = 8;  // voxels

[[noreturn]] void refuseTissue(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

TissueLevel firstLevel(ScanTissue tissue) {
  switch (tissue) {
    case ScanTissue::kSkin:
      return {kSkin_HU, 1000.0};
    case ScanTissue::kLabel:
      return {0.5 * kWholeVoxel, kWholeVoxel};
    case ScanTissue::kGasLumen:
    case ScanTissue::kWall:
      break;
  }
  return {kGas_HU, -1000.0};
}

bool isGas(ScanTissue tissue) {
  return tissue == ScanTissue::kGasLumen || tissue == ScanTissue::kWall;
}

VoxelMask withinLevel(const WorkGrid& grid, const TissueLevel& level) {
  return scannedWhere(grid, [&](std::size_t x, std::size_t y, std::size_t z) {
    return level.isInside(grid.volume.values[grid.volume.index(x, y, z)]);
  });
}

double millilitres(const WorkGrid& grid, std::size_t voxels) {
  return 0.001 * std::abs(grid.volume.voxel_mm3()) * static_cast<double>(voxels);
}

Text placeText(const Vec3& mm) {
  const auto whole = [](double x) { return std::to_string(std::lround(x)); };
  return Text::verbatim("%1,%2,%3", whole(mm.x), whole(mm.y), whole(mm.z));
}

Text pieceText(const WorkGrid& grid, const MaskPiece& piece) {
  const Vec3 middle = grid.volume.place_mm({piece.middle[0], piece.middle[1], piece.middle[2]});
  return Text::verbatim("%1 ml (%2)", shortNumber(millilitres(grid, piece.voxels)), placeText(middle));
}

std::size_t bordersOf(const MaskPiece& piece) {
  return static_cast<std::size_t>(std::count(piece.atBorder.begin(), piece.atBorder.end(), true));
}

/// Open to the air round the patient: reaches a side of the slices.
bool isOpen(const MaskPiece& piece) {
  return std::any_of(piece.atBorder.begin(), piece.atBorder.begin() + 4,
                     [](bool touches) { return touches; });
}

/// The piece within reach of the seed; throws where there is none.
std::size_t pieceAtSeed(const WorkGrid& grid, const MaskPieces& pieces, const Vec3& seed_mm,
                        const std::string& where) {
  const Vec3 at = grid.volume.voxelAt(seed_mm);
  const std::array<double, 3> seed{at.x, at.y, at.z};
  std::array<long, 3> middle{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(seed[axis] >= static_cast<double>(grid.low()[axis]) - 0.5 &&
          seed[axis] <= static_cast<double>(grid.high()[axis]) - 0.5)) {
      refuseTissue(Text::tr("D16 the seed %1 is outside the scan or the box", placeText(seed_mm)), where,
                   Text::tr("Give a point in millimetres: x to the left, y to the back, z up"));
    }
    middle[axis] = std::lround(seed[axis]);
  }
  std::size_t found = pieces.list().size();
  long nearest = 1 + kSeedReach * kSeedReach;
  for (long z = -kSeedReach; z <= kSeedReach; ++z) {
    for (long y = -kSeedReach; y <= kSeedReach; ++y) {
      for (long x = -kSeedReach; x <= kSeedReach; ++x) {
        const std::array<long, 3> voxel{middle[0] + x, middle[1] + y, middle[2] + z};
        bool inside = x * x + y * y + z * z < nearest;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          inside = inside && voxel[axis] >= 0 && voxel[axis] < static_cast<long>(grid.volume.count[axis]);
        }
        if (!inside) {
          continue;
        }
        const std::size_t piece =
            pieces.at(static_cast<std::size_t>(voxel[0]), static_cast<std::size_t>(voxel[1]),
                      static_cast<std::size_t>(voxel[2]));
        if (piece < pieces.list().size()) {
          found = piece;
          nearest = x * x + y * y + z * z;
        }
      }
    }
  }
  if (found == pieces.list().size()) {
    const std::int16_t value = grid.volume.values[grid.volume.index(static_cast<std::size_t>(middle[0]),
                                                                    static_cast<std::size_t>(middle[1]),
                                                                    static_cast<std::size_t>(middle[2]))];
    refuseTissue(Text::tr("D16 there is no such tissue at the seed %1, where the scan has the value %2",
                          placeText(seed_mm), std::to_string(value)),
                 where, Text::tr("Give a point inside of the organ"));
  }
  return found;
}

/// The organ among the pieces, without a seed.
std::size_t largestPiece(const WorkGrid& grid, const MaskPieces& pieces, ScanTissue tissue,
                         const std::string& where, std::vector<ScanRemark>& remarks) {
  std::vector<std::size_t> fit;
  for (std::size_t i = 0; i < pieces.list().size(); ++i) {
    if (!isGas(tissue) || !isOpen(pieces.list()[i])) {
      fit.push_back(i);
    }
  }
  if (fit.empty()) {
    refuseTissue(isGas(tissue) ? Text::tr("D16 no gas is enclosed in this scan")
                               : Text::tr("D16 the scan contains no such tissue"),
                 where, Text::tr("Choose another --tissue, or another scan"));
  }
  const auto voxels = [&pieces, &fit](std::size_t n) {
    return static_cast<double>(pieces.list()[fit[n]].voxels);
  };
  std::vector<Text> texts;
  for (std::size_t n = 0; n < std::min(fit.size(), kListedPieces) && voxels(n) > kSmallPiece * voxels(0);
       ++n) {
    texts.push_back(pieceText(grid, pieces.list()[fit[n]]));
  }
  if (isGas(tissue) && fit.size() > 1 && voxels(1) > kAlike * voxels(0)) {
    refuseTissue(Text::tr("D16 several spaces are filled with gas: %1", listed(texts)), where,
                 Text::tr("Name the organ with --seed x,y,z, or look at a part with --box"));
  }
  if (texts.size() > 1) {
    remarks.push_back({"D16", false, Text::tr("the largest of several pieces was taken: %1", listed(texts)),
                       std::nullopt, Text::tr("Name another one with --seed x,y,z")});
  }
  return fit[0];
}

/// Skin that reaches too many borders because it lies on a flat table: without the table. None otherwise.
std::optional<VoxelMask> offTheTable(const WorkGrid& grid, const VoxelMask& within,
                                     const ScanRequest& request, std::vector<ScanRemark>& remarks) {
  if (request.tissue != ScanTissue::kSkin) {
    return std::nullopt;
  }
  const std::optional<TablePlane> table = tableIn(grid, within);
  if (!table) {
    return std::nullopt;
  }
  VoxelMask body = within;
  removeTable(grid, *table, body);
  remarks.push_back(
      {"D21", true,
       Text::tr("the table was cut off at y = %1 mm; the body is flat where it lay on the table",
                shortNumber(table->at_mm)),
       table->at_mm, Text::tr("Check the mask over the slices")});
  return body;
}

/// Cuts thin bridges and returns the organ's piece, with all of its border.
VoxelMask chosenPiece(const WorkGrid& grid, const VoxelMask& within, const ScanRequest& request,
                      const std::string& where, std::vector<ScanRemark>& remarks, bool onTable = true) {
  VoxelMask core = within.shrunk(1);
  if (core.voxels() == 0) {
    core = within;
  }
  // A core lies a voxel inside of what it is the core of.
  const VoxelMask::Count low{grid.low()[0] + 1, grid.low()[1] + 1, grid.low()[2] + 1};
  const VoxelMask::Count high{grid.high()[0] - 1, grid.high()[1] - 1, grid.high()[2] - 1};
  const MaskPieces pieces(core, low, high);
  const auto before = static_cast<std::ptrdiff_t>(remarks.size());
  const std::size_t chosen = request.seed_mm ? pieceAtSeed(grid, pieces, *request.seed_mm, where)
                                             : largestPiece(grid, pieces, request.tissue, where, remarks);
  const MaskPiece& piece = pieces.list()[chosen];
  if (bordersOf(piece) > kMaxBorders) {
    if (onTable) {
      remarks.erase(remarks.begin() + before, remarks.end());  // of pieces that are reported again
      if (const auto body = offTheTable(grid, within, request, remarks)) {
        return chosenPiece(grid, *body, request, where, remarks, false);
      }
    }
    refuseTissue(
        Text::tr("D16 the tissue reaches %1 of the 6 borders of the scan: it leaks, or the scan shows a part",
                 std::to_string(bordersOf(piece))),
        where, Text::tr("Give a --seed inside of the organ, or cut it out with --box"));
  }
  VoxelMask organ = pieces.mask(chosen).grown(2);
  organ.keepOnly(within);
  const double volume_ml = millilitres(grid, organ.voxels());
  if (isGas(request.tissue) && volume_ml > kMaxLumen_ml) {
    refuseTissue(Text::tr("D16 the gas leaks: it fills %1 ml, a stomach holds at most %2 ml",
                          shortNumber(volume_ml), shortNumber(kMaxLumen_ml)),
                 where, Text::tr("Give a --seed inside of the organ, or cut it out with --box"));
  }
  return organ;
}

double medianWithin(const WorkGrid& grid, const VoxelMask& mask, double otherwise) {
  constexpr std::size_t kEnough = 2'000'000;
  std::vector<std::int16_t> values;
  const auto& count = grid.volume.count;
  const std::size_t every = std::max<std::size_t>(1, grid.volume.values.size() / (8 * kEnough));
  for (std::size_t z = 0; z < count[2]; z += every) {
    for (std::size_t y = 0; y < count[1]; ++y) {
      for (std::size_t x = 0; x < count[0]; ++x) {
        if (mask.at(x, y, z)) {
          values.push_back(grid.volume.values[grid.volume.index(x, y, z)]);
        }
      }
    }
  }
  if (values.empty()) {
    return otherwise;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Half way between what lies inside of the piece and what lies round it, away from its border.
TissueLevel measuredLevel(const WorkGrid& grid, const VoxelMask& piece, const TissueLevel& first) {
  VoxelMask around = piece.grown(4);
  around.remove(piece.grown(2));
  around.keepOnly(scannedVoxels(grid));
  const double inside = medianWithin(grid, piece.shrunk(2), first.level + 0.5 * first.contrast);
  const double outside = medianWithin(grid, around, first.level - 0.5 * first.contrast);
  const double level = 0.5 * (inside + outside);
  const bool plausible =
      (inside - outside) * first.contrast > 0.0 && std::abs(level - first.level) <= kMaxCorrection_HU;
  return plausible ? TissueLevel{level, inside - outside} : first;
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

double TissueLevel::share(double value) const noexcept {
  return std::clamp(0.5 + (value - level) / contrast, 0.0, 1.0);
}

VoxelMask scannedVoxels(const WorkGrid& grid) {
  return scannedWhere(grid, [](std::size_t, std::size_t, std::size_t) { return true; });
}

FoundPiece foundPiece(const WorkGrid& grid, const ScanRequest& request, const std::string& where,
                      std::vector<ScanRemark>& remarks) {
  TissueLevel level = firstLevel(request.tissue);
  if (request.tissue != ScanTissue::kLabel) {
    std::vector<ScanRemark> ignored;
    const VoxelMask first = chosenPiece(grid, withinLevel(grid, level), request, where, ignored);
    level = measuredLevel(grid, first, level);
  }
  VoxelMask piece = chosenPiece(grid, withinLevel(grid, level), request, where, remarks);
  return {std::move(piece), level};
}

FoundPiece densePiece(const WorkGrid& grid, double threshold_HU, const std::optional<Vec3>& seed_mm,
                      const std::string& where, std::vector<ScanRemark>& remarks) {
  constexpr double kDefaultContrast_HU = 1000.0;
  constexpr double kLeastContrast_HU = 200.0;
  const TissueLevel first{threshold_HU, kDefaultContrast_HU};
  const MaskPieces pieces(withinLevel(grid, first), grid.low(), grid.high());
  if (pieces.list().empty()) {
    refuseTissue(Text::tr("D16 nothing in this scan is denser than %1 HU", shortNumber(threshold_HU)), where,
                 Text::tr("Give a lower threshold, or another scan"));
  }
  const std::size_t chosen = seed_mm ? pieceAtSeed(grid, pieces, *seed_mm, where)
                                     : largestPiece(grid, pieces, ScanTissue::kSkin, where, remarks);
  VoxelMask piece = pieces.mask(chosen);
  const double contrast = std::max(measuredLevel(grid, piece, first).contrast, kLeastContrast_HU);
  return {std::move(piece), {threshold_HU, contrast}};
}

VoxelMask wholeOrgan(const WorkGrid& grid, const VoxelMask& piece, int closing) {
  VoxelMask organ = piece.closed(closing);
  fillLids(organ, grid.low(), grid.high());
  organ = organ.filled();
  const MaskPieces pieces(organ, grid.low(), grid.high());
  return pieces.list().size() > 1 ? pieces.mask(0) : organ;
}

std::optional<ScanRemark> cutOff(const WorkGrid& grid, const VoxelMask& organ) {
  const MaskPieces pieces(organ, grid.low(), grid.high());
  std::vector<Text> sides;
  for (std::size_t side = 0; !pieces.list().empty() && side < 6; ++side) {
    if (!pieces.list()[0].atBorder[side]) {
      continue;
    }
    const Vec3 out = (side % 2 == 0 ? -1.0 : 1.0) * grid.volume.step_mm[side / 2];
    const double most = std::max({std::abs(out.x), std::abs(out.y), std::abs(out.z)});
    sides.emplace_back(most == std::abs(out.x)
                           ? (out.x > 0.0 ? Text::tr("towards the left") : Text::tr("towards the right"))
                       : most == std::abs(out.y)
                           ? (out.y > 0.0 ? Text::tr("towards the back") : Text::tr("towards the front"))
                           : (out.z > 0.0 ? Text::tr("towards the head") : Text::tr("towards the feet")));
  }
  if (sides.empty()) {
    return std::nullopt;
  }
  return ScanRemark{
      "D17", true,
      Text::tr("the scan cuts off the organ (%1): its flat end is not real anatomy", listed(sides)),
      static_cast<double>(sides.size()),
      Text::tr("Name it as an end of the organ, or give a scan that shows all of it")};
}

}  // namespace torsio
