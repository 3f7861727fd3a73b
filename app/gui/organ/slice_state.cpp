// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/slice_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/imaging/surface/voxel_mask.h"

namespace torsio::gui {

namespace {

void paintOver(ScanPreview& preview, const BrushDab& dab) {
  const ScanVolume& volume = preview.volume;
  eachVoxelIn(dab, volume, {0, 0, 0}, volume.count, [&](std::size_t x, std::size_t y, std::size_t z) {
    preview.within[volume.index(x, y, z)] = dab.adds ? 1 : 0;
  });
}

}  // namespace

void SliceState::setPreview(ScanPreview scan) {
  const double level_HU = level;
  const double width_HU = width;
  *this = {};
  level = level_HU;
  width = width_HU;
  preview = std::move(scan);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = static_cast<int>(preview.volume.count[axis] / 2);
  }
}

void SliceState::setFound(ScanPreview organ) {
  preview = std::move(organ);
  found = preview.within;
  repaint();
}

void SliceState::repaint() {
  preview.within = found;
  for (const std::vector<BrushDab>& stroke : strokes) {
    for (const BrushDab& dab : stroke) {
      paintOver(preview, dab);
    }
  }
}

void SliceState::paint(const BrushDab& dab) {
  if (found.empty() || strokes.empty()) {
    return;
  }
  strokes.back().push_back(dab);
  paintOver(preview, dab);
}

void SliceState::undoStroke() {
  if (!strokes.empty()) {
    strokes.pop_back();
    repaint();
  }
}

void SliceState::clearStrokes() {
  strokes.clear();
  repaint();
}

std::vector<BrushDab> SliceState::dabs() const {
  std::vector<BrushDab> all;
  for (const std::vector<BrushDab>& stroke : strokes) {
    all.insert(all.end(), stroke.begin(), stroke.end());
  }
  return all;
}

Vec3 SliceState::placeOf_mm(const PreviewVoxel& voxel) const {
  return preview.volume.place_mm(
      {static_cast<double>(voxel[0]), static_cast<double>(voxel[1]), static_cast<double>(voxel[2])});
}

std::optional<ScanBox> SliceState::box_mm() const {
  if (!box) {
    return std::nullopt;
  }
  return ScanBox{placeOf_mm((*box)[0]), placeOf_mm((*box)[1])};
}

std::optional<double> SliceState::volume_ml() const {
  if (preview.within.empty()) {
    return std::nullopt;
  }
  constexpr double kMillilitre_mm3 = 1000.0;
  const auto voxels = static_cast<double>(std::count(preview.within.begin(), preview.within.end(), 1));
  return std::abs(preview.volume.voxel_mm3()) * voxels / kMillilitre_mm3;
}

}  // namespace torsio::gui
