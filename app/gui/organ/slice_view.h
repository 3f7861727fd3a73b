// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <QImage>
#include <QWidget>

#include "app/gui/widgets/theme.h"
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

/// A slice of a scan in grey, with the organ's mask, box, seed and the two other slices. Radiological
/// orientation: the patient's left on the right, axial from the feet, sagittal from the left. Wheel and arrow
/// keys move through slices; a right drag changes the window.
class SliceView : public QWidget {
  Q_OBJECT

 public:
  /// `state`: the panel's; must outlive the view.
  SliceView(SliceState& state, SlicePlane plane, QWidget* parent = nullptr);

  /// Redraws after a change of the state.
  void refresh();
  void setTheme(const Theme& theme);
  /// Shows a circle of this radius at the mouse; 0: none.
  void setBrush(double radius_mm);
  [[nodiscard]] SlicePlane plane() const noexcept { return plane_; }
  /// Returns the voxel at a pixel of the widget; empty outside of the slice.
  [[nodiscard]] std::optional<PreviewVoxel> voxelAt(const QPointF& pixel) const;
  /// Returns the pixel of a voxel's centre.
  [[nodiscard]] QPointF pixelOf(const PreviewVoxel& voxel) const;
  [[nodiscard]] QSize sizeHint() const override { return {360, 300}; }

 Q_SIGNALS:
  /// The left button was pressed, dragged or released over a voxel.
  void pressed(const torsio::gui::PreviewVoxel& voxel);
  void dragged(const torsio::gui::PreviewVoxel& voxel);
  void released();
  /// The slice or grey window was changed here: all views need redrawing.
  void moved();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  [[nodiscard]] QRectF slicePlace() const;
  [[nodiscard]] QImage slicePicture() const;
  [[nodiscard]] PreviewVoxel clamped(PreviewVoxel voxel) const;
  void drawMarks(QPainter& painter) const;
  void drawLetters(QPainter& painter) const;
  void step(int slices);

  SliceState& state_;
  SlicePlane plane_;
  std::size_t across_;  // preview axis that points right
  std::size_t along_;   // preview axis that points down or up
  bool upwards_;        // along_ points up
  QImage picture_;
  Theme theme_;
  double brush_mm_ = 0.0;
  std::optional<QPointF> mouse_;
  std::optional<QPointF> windowing_;  // last position of a right drag
};

}  // namespace torsio::gui
