// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/imaging/surface/scan_preview.h"

namespace torsio::gui {

/// One of the three ways to cut a scan; the axis that it is cut across: left, back, head.
enum class SlicePlane : std::uint8_t { kSagittal = 0, kCoronal = 1, kAxial = 2 };

/// A voxel of a preview.
using PreviewVoxel = std::array<int, 3>;

/// A scan that is looked at, and what somebody said about it: what the three views share. Plain value.
struct SliceState {
  ScanPreview preview;
  PreviewVoxel at{};     ///< where the three slices cross
  double level = 40.0;   ///< grey half way, HU
  double width = 400.0;  ///< from black to white, HU
  std::optional<Vec3> seed_mm;
  std::optional<std::array<PreviewVoxel, 2>> box;  ///< lowest and highest voxel, both within
  std::vector<std::uint8_t> found;                 ///< the mask before the brush
  std::vector<std::vector<BrushDab>> strokes;

  /// Takes another scan; everything else as at first.
  void setPreview(ScanPreview scan);
  /// Takes the organ that was found in the scan, and brushes the strokes over it.
  void setFound(ScanPreview organ);
  /// Adds a dab to the last stroke and paints it.
  void paint(const BrushDab& dab);
  /// Takes the last stroke, or all of them, back.
  void undoStroke();
  void clearStrokes();
  /// All strokes, one after another.
  [[nodiscard]] std::vector<BrushDab> dabs() const;
  /// The box in the patient's axes.
  [[nodiscard]] std::optional<ScanBox> box_mm() const;
  [[nodiscard]] bool empty() const noexcept { return preview.volume.values.empty(); }
  [[nodiscard]] Vec3 placeOf_mm(const PreviewVoxel& voxel) const;
  /// Millilitres of the mask as it is now; none without one.
  [[nodiscard]] std::optional<double> volume_ml() const;

 private:
  void repaint();
};

}  // namespace torsio::gui
