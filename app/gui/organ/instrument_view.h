// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "sim/imaging/surface/tool_surface.h"

namespace torsio::gui {

/// An instrument found in a scan, with tip, axis, hinge and opened jaws: as a whole, and its front seen along
/// and across the hinge. A click sets the tip or the hinge. GUI thread.
class InstrumentView : public QWidget {
  Q_OBJECT

 public:
  explicit InstrumentView(QWidget* parent = nullptr);

  void setTool(const ToolSurface& tool, double opening_deg);
  void setOpening(double opening_deg);
  void setTheme(const Theme& theme);
  [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }

  /// Handles a click at a place of the widget.
  void pickAt(const QPointF& place);
  /// Returns the position of a point of the shaft's axis in the row of the whole instrument (0), of its front
  /// along the hinge (1) or from above (2).
  [[nodiscard]] QPointF placeOf(int row, double fromTip_mm) const;

 Q_SIGNALS:
  /// The user says that the tip is at the other end.
  void otherEndPicked();
  /// The user has set the distance of the hinge behind the tip.
  void hingePicked(double fromTip_mm);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  /// A part of the widget, with range and direction of view.
  struct Pane {
    QRectF area;
    double from_mm;  // along the shaft, at the left edge
    double perMm;
    bool alongHinge;  // false: from above
  };
  static constexpr int kPanes = 3;  // whole, along the hinge, from above
  [[nodiscard]] Pane pane(int row) const;
  [[nodiscard]] double shownLength_mm(int row) const;
  /// Returns the half length of the hinge line in the view from above.
  [[nodiscard]] double hingeMark_mm() const;
  void measure();
  void paintPane(QPainter& painter, int row) const;
  void paintMesh(QPainter& painter, const Pane& pane, const TriangleMesh& mesh, const QColor& colour,
                 double turn_rad) const;

  ToolSurface tool_;
  double opening_deg_ = 0.0;
  std::array<double, kPanes> halfAcross_mm_{};  // from the axis, for each row
  Theme theme_;
};

}  // namespace torsio::gui
