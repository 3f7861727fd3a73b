// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/imaging/surface/scan_preview.h"

namespace torsio::gui {

/// A slice plane; its value is the axis normal to it: left, back, head.
enum class SlicePlane : std::uint8_t { kSagittal = 0, kCoronal = 1, kAxial = 2 };

/// A voxel of a preview.
using PreviewVoxel = std::array<int, 3>;

/// A scan and the user's input, shared by the three views. Plain value.
struct SliceState {
  ScanPreview preview;
  PreviewVoxel at{};     ///< intersection of the three slices
  double level = 40.0;   ///< mid-grey, HU
  double width = 400.0;  ///< black to white, HU
  std::optional<Vec3> seed_mm;
  std::optional<std::array<PreviewVoxel, 2>> box;  ///< lowest and highest voxel, inclusive
  std::vector<std::uint8_t> found;                 ///< mask without brush strokes
  std::vector<std::vector<BrushDab>> strokes;

  /// Takes another scan and resets everything else.
  void setPreview(ScanPreview scan);
  /// Takes the segmented organ and reapplies the strokes.
  void setFound(ScanPreview organ);
  /// Adds a dab to the last stroke and paints it.
  void paint(const BrushDab& dab);
  /// Undoes the last stroke, or all.
  void undoStroke();
  void clearStrokes();
  /// Returns the dabs of all strokes, in order.
  [[nodiscard]] std::vector<BrushDab> dabs() const;
  /// Returns the box in the patient's axes.
  [[nodiscard]] std::optional<ScanBox> box_mm() const;
  [[nodiscard]] bool empty() const noexcept { return preview.volume.values.empty(); }
  [[nodiscard]] Vec3 placeOf_mm(const PreviewVoxel& voxel) const;
  /// Returns the volume of the present mask, ml; empty without one.
  [[nodiscard]] std::optional<double> volume_ml() const;

 private:
  void repaint();
};

}  // namespace torsio::gui
