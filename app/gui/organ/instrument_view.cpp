// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/instrument_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <QMouseEvent>
#include <QPainter>

#include "sim/core/angle.h"
#include "sim/core/pose.h"

namespace torsio::gui {

namespace {

constexpr double kViewMillimetres = 1000.0;  // in a metre
constexpr double kMargin_mm = 6.0;
constexpr double kFront = 2.6;  // length of the front shown, in hinge distances
constexpr double kCaption = 22.0;
constexpr double kHingeMark_mm = 3.0;  // minimum, to each side
constexpr double kBeside = 4.0;        // margin above and below the drawing, px

bool alongHinge(int row) {
  return row < 2;
}

/// A projected triangle.
struct Facet {
  std::array<QPointF, 3> corners;
  double depth = 0.0;
  double light = 1.0;
};

}  // namespace

InstrumentView::InstrumentView(QWidget* parent) : QWidget(parent), theme_(theme(ThemeKind::kLight)) {
  setMinimumSize(320, 300);
}

void InstrumentView::setTool(const ToolSurface& tool, double opening_deg) {
  tool_ = tool;
  setOpening(opening_deg);
}

void InstrumentView::setOpening(double opening_deg) {
  opening_deg_ = opening_deg;
  measure();
  update();
}

void InstrumentView::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

double InstrumentView::shownLength_mm(int row) const {
  return row == 0 ? tool_.length_mm : kFront * tool_.pivot_mm;
}

double InstrumentView::hingeMark_mm() const {
  return std::max(kHingeMark_mm, tool_.shaftRadius_mm);
}

void InstrumentView::measure() {
  const Vec3 pivot{0.0, 0.0, tool_.pivot_mm};
  const double opening_rad = radians(opening_deg_);
  for (int row = 0; row < kPanes; ++row) {
    double& half = halfAcross_mm_[static_cast<std::size_t>(row)];
    half = alongHinge(row) ? 0.0 : hingeMark_mm();
    const auto add = [&](const TriangleMesh& mesh, double turn_rad) {
      for (const Vec3& v : mesh.vertices_m) {
        const Vec3 at = pivot + rotateAbout(kViewMillimetres * v - pivot, {1.0, 0.0, 0.0}, turn_rad);
        if (at.z <= shownLength_mm(row) + kMargin_mm) {
          half = std::max(half, std::abs(alongHinge(row) ? at.y : at.x));
        }
      }
    };
    for (const TriangleMesh* mesh : {&tool_.shaft, &tool_.upperJaw, &tool_.lowerJaw}) {
      add(*mesh, 0.0);
    }
    if (alongHinge(row)) {
      add(tool_.upperJaw, opening_rad);
      add(tool_.lowerJaw, -opening_rad);
    }
  }
}

InstrumentView::Pane InstrumentView::pane(int row) const {
  const double height = static_cast<double>(this->height()) / kPanes;
  Pane pane;
  pane.area = QRectF(0.0, row * height + kCaption, width(), height - kCaption);
  pane.alongHinge = alongHinge(row);
  pane.from_mm = -kMargin_mm;
  const double shown_mm = shownLength_mm(row) + 2.0 * kMargin_mm;
  const double across_mm = 2.0 * halfAcross_mm_[static_cast<std::size_t>(row)];
  // A wide window shows more of the shaft, but no less of the jaws.
  pane.perMm = std::min(width() / std::max(shown_mm, 1.0),
                        std::max(pane.area.height() - 2.0 * kBeside, 1.0) / std::max(across_mm, 1.0));
  return pane;
}

QPointF InstrumentView::placeOf(int row, double fromTip_mm) const {
  const Pane at = pane(row);
  return {(fromTip_mm - at.from_mm) * at.perMm, at.area.center().y()};
}

void InstrumentView::pickAt(const QPointF& place) {
  if (tool_.length_mm <= 0.0) {
    return;
  }
  const int row = std::clamp(static_cast<int>(place.y() * kPanes / std::max(height(), 1)), 0, kPanes - 1);
  const Pane at = pane(row);
  const double fromTip_mm = at.from_mm + place.x() / at.perMm;
  if (row > 0) {
    Q_EMIT hingePicked(fromTip_mm);
  } else if (fromTip_mm > 0.5 * tool_.length_mm) {
    Q_EMIT otherEndPicked();
  }
}

void InstrumentView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    pickAt(event->position());
  }
}

void InstrumentView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.backdrop);
  if (tool_.length_mm <= 0.0) {
    return;
  }
  const std::array<QString, kPanes> captions{
      tr("Whole instrument: click the other half to make its end the tip"),
      tr("Front, along the hinge: click to place the hinge"), tr("Front, from above")};
  for (int row = 0; row < kPanes; ++row) {
    const Pane one = pane(row);
    painter.setPen(theme_.text);
    painter.drawText(QRectF(8.0, one.area.top() - kCaption, width() - 16.0, kCaption),
                     Qt::AlignLeft | Qt::AlignVCenter, captions[static_cast<std::size_t>(row)]);
    paintPane(painter, row);
  }
}

void InstrumentView::paintPane(QPainter& painter, int row) const {
  const Pane pane = this->pane(row);
  painter.save();
  painter.setClipRect(pane.area);
  const double opening_rad = radians(opening_deg_);
  paintMesh(painter, pane, tool_.shaft, theme_.shaft, 0.0);
  if (pane.alongHinge) {  // opened jaws, behind the closed ones
    painter.setOpacity(0.35);
    paintMesh(painter, pane, tool_.upperJaw, theme_.grasp, opening_rad);
    paintMesh(painter, pane, tool_.lowerJaw, theme_.grasp, -opening_rad);
    painter.setOpacity(1.0);
  }
  paintMesh(painter, pane, tool_.lowerJaw, theme_.shaft.darker(120), 0.0);
  paintMesh(painter, pane, tool_.upperJaw, theme_.shaft.lighter(115), 0.0);

  const auto at = [&](double fromTip_mm) { return placeOf(row, fromTip_mm); };
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme_.accent, 1.5, Qt::DashLine));
  painter.drawLine(at(0.0), at(tool_.length_mm));
  painter.setPen(QPen(theme_.caution, 2.5));
  if (pane.alongHinge) {
    painter.drawEllipse(at(tool_.pivot_mm), 5.0, 5.0);
  } else {
    const QPointF across(0.0, hingeMark_mm() * pane.perMm);
    painter.drawLine(at(tool_.pivot_mm) - across, at(tool_.pivot_mm) + across);
  }
  painter.setBrush(theme_.accent);
  painter.setPen(Qt::NoPen);
  painter.drawEllipse(at(0.0), 5.0, 5.0);
  painter.restore();
}

void InstrumentView::paintMesh(QPainter& painter, const Pane& pane, const TriangleMesh& mesh,
                               const QColor& colour, double turn_rad) const {
  std::vector<Facet> facets;
  facets.reserve(mesh.triangles.size());
  const Vec3 pivot{0.0, 0.0, tool_.pivot_mm};
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    Facet facet;
    for (std::size_t k = 0; k < 3; ++k) {
      // The upper jaw (y > 0) opens away from the axis: turns towards -z of the hinge.
      p[k] = pivot + rotateAbout(kViewMillimetres * mesh.vertices_m[t[k]] - pivot, {1, 0, 0}, turn_rad);
      const double across_mm = pane.alongHinge ? p[k].y : p[k].x;
      facet.depth += pane.alongHinge ? p[k].x : p[k].y;
      facet.corners[k] = {(p[k].z - pane.from_mm) * pane.perMm,
                          pane.area.center().y() - across_mm * pane.perMm};
    }
    const Vec3 normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
    const double facing = pane.alongHinge ? normal.x : normal.y;
    if (facing > 0.0) {
      facet.light = 0.45 + 0.55 * facing;
      facets.push_back(facet);
    }
  }
  std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return a.depth < b.depth; });
  for (const Facet& facet : facets) {
    const QColor shaded = QColor::fromRgbF(static_cast<float>(facet.light) * colour.redF(),
                                           static_cast<float>(facet.light) * colour.greenF(),
                                           static_cast<float>(facet.light) * colour.blueF());
    painter.setPen(shaded);
    painter.setBrush(shaded);
    painter.drawPolygon(facet.corners.data(), 3);
  }
}

}  // namespace torsio::gui
