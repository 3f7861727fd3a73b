// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/organ_marks.h"

#include <utility>

#include <QEvent>
#include <QPainter>
#include <QPolygonF>

#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"

namespace torsio::gui {

namespace {

constexpr double kDot_px = 5.0;
constexpr double kAxis_px = 2.5;
constexpr double kNameAway_px = 9.0;
constexpr double kNameMargin_px = 4.0;

}  // namespace

OrganMarks::OrganMarks(SceneView& view) : QWidget(&view), view_(view), theme_(theme(ThemeKind::kLight)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  view.installEventFilter(this);
  connect(&view, &SceneView::cameraChanged, this, qOverload<>(&QWidget::update));
  resize(view.size());
}

void OrganMarks::setAxis(std::vector<Vec3> axis_m, std::vector<OrganLandmark> landmarks) {
  axis_m_ = std::move(axis_m);
  landmarks_ = std::move(landmarks);
  raise();
  update();
}

void OrganMarks::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

QString OrganMarks::nameOf(OrganLandmark::Kind kind) {
  switch (kind) {
    case OrganLandmark::Kind::kFixedEnd:
      return tr("held end");
    case OrganLandmark::Kind::kFreeEnd:
      return tr("free end");
    case OrganLandmark::Kind::kWidest:
      return tr("widest");
    case OrganLandmark::Kind::kNarrowest:
      break;
  }
  return tr("narrowest");
}

bool OrganMarks::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    resize(view_.size());
    raise();
  }
  return false;
}

QPointF OrganMarks::pixelOf(const Vec3& place_m) const {
  return view_.camera().pixel(toView(place_m), QSizeF(view_.size()));
}

void OrganMarks::drawName(QPainter& painter, const QPointF& at, const QString& name) const {
  const QFontMetricsF metrics(painter.font());
  QRectF box(at.x() + kNameAway_px, at.y() - 0.5 * metrics.height(),
             metrics.horizontalAdvance(name) + 2.0 * kNameMargin_px, metrics.height());
  if (box.right() > width()) {
    box.moveRight(at.x() - kNameAway_px);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.surface);
  painter.drawRoundedRect(box, kNameMargin_px, kNameMargin_px);
  painter.setPen(theme_.text);
  painter.drawText(box, Qt::AlignCenter, name);
}

void OrganMarks::paintEvent(QPaintEvent*) {
  if (!view_.draws()) {
    return;  // the view shows only an explanation
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPointSizeF(kSmallText_pt);
  painter.setFont(font);
  QPolygonF line;
  for (const Vec3& place_m : axis_m_) {
    line << pixelOf(place_m);
  }
  painter.setPen(QPen(theme_.accent, kAxis_px, Qt::DashLine));
  painter.drawPolyline(line);
  for (const OrganLandmark& landmark : landmarks_) {
    const QPointF at = pixelOf(landmark.place_m);
    painter.setPen(QPen(theme_.surface, 1.0));
    painter.setBrush(theme_.accent);
    painter.drawEllipse(at, kDot_px, kDot_px);
    drawName(painter, at, nameOf(landmark.kind));
  }
}

}  // namespace torsio::gui
