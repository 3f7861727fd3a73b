// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "sim/imaging/surface/tool_surface.h"

namespace torsio::gui {

/// An instrument that was found in a scan, with its tip, axis, hinge and opened jaws: the whole of it, and
/// its front seen along the hinge and across it. A click says where the tip or the hinge is. GUI thread.
class InstrumentView : public QWidget {
  Q_OBJECT

 public:
  explicit InstrumentView(QWidget* parent = nullptr);

  void setTool(const ToolSurface& tool, double opening_deg);
  void setOpening(double opening_deg);
  void setTheme(const Theme& theme);
  [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }

  /// What a click at a place of the widget says; as a mouse button does.
  void pickAt(const QPointF& place);
  /// Where a point of the shaft's axis is drawn, in the row of the whole instrument (0), of its front along
  /// the hinge (1) or from above (2).
  [[nodiscard]] QPointF placeOf(int row, double fromTip_mm) const;

 Q_SIGNALS:
  /// The tip is at the other end.
  void otherEndPicked();
  /// The hinge is so far behind the tip.
  void hingePicked(double fromTip_mm);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  /// Part of the widget, what of the instrument it shows, and from where.
  struct Pane {
    QRectF area;
    double from_mm;  // along the shaft, at the left
    double perMm;
    bool alongHinge;  // else from above
  };
  static constexpr int kPanes = 3;  // the whole, along the hinge, from above
  [[nodiscard]] Pane pane(int row) const;
  [[nodiscard]] double shownLength_mm(int row) const;
  /// How far the line of the hinge reaches to each side, from above.
  [[nodiscard]] double hingeMark_mm() const;
  void measure();
  void paintPane(QPainter& painter, int row) const;
  void paintMesh(QPainter& painter, const Pane& pane, const TriangleMesh& mesh, const QColor& colour,
                 double turn_rad) const;

  ToolSurface tool_;
  double opening_deg_ = 0.0;
  std::array<double, kPanes> halfAcross_mm_{};  // of what each row shows, from the axis
  Theme theme_;
};

}  // namespace torsio::gui
