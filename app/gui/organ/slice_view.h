// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QImage>
#include <QWidget>

#include "app/gui/organ/slice_state.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

/// One slice of a scan in grey, the organ's mask, the box, the seed and the two other slices drawn over it.
/// Seen as radiologists do: the patient's left on the right, axial from the feet, sagittal from the left. The
/// wheel and the arrow keys go through the slices; a drag with the right button changes the window.
class SliceView : public QWidget {
  Q_OBJECT

 public:
  /// `state` is the panel's and outlives the view.
  SliceView(SliceState& state, SlicePlane plane, QWidget* parent = nullptr);

  /// What is shown has changed.
  void refresh();
  void setTheme(const Theme& theme);
  /// A circle of this radius follows the mouse; 0: none.
  void setBrush(double radius_mm);
  [[nodiscard]] SlicePlane plane() const noexcept { return plane_; }
  /// The voxel at a pixel of the widget; none outside of the slice.
  [[nodiscard]] std::optional<PreviewVoxel> voxelAt(const QPointF& pixel) const;
  /// The pixel of a voxel's middle.
  [[nodiscard]] QPointF pixelOf(const PreviewVoxel& voxel) const;
  [[nodiscard]] QSize sizeHint() const override { return {360, 300}; }

 Q_SIGNALS:
  /// The left button went down, moved or came up over a voxel.
  void pressed(const torsio::gui::PreviewVoxel& voxel);
  void dragged(const torsio::gui::PreviewVoxel& voxel);
  void released();
  /// Another slice, or another window of grey, was chosen here: all views are to be drawn anew.
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
  std::size_t across_;  // axis of the preview that runs to the right
  std::size_t along_;   // and the one that runs down or up
  bool upwards_;        // it runs up
  QImage picture_;
  Theme theme_;
  double brush_mm_ = 0.0;
  std::optional<QPointF> mouse_;
  std::optional<QPointF> windowing_;  // where the right button went down last
};

}  // namespace torsio::gui
