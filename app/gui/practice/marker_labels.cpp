// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/marker_labels.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QPainter>

#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/scene/view_turn.h"

namespace torsio::gui {

namespace {

constexpr double kLabelRadius_px = 10.0;
constexpr double kHiddenShare = 0.35;      ///< opacity of a disc on the far side
constexpr double kHiddenNumber = 0.7;      ///< opacity of its number, which stays readable
constexpr double kSkinThickness_mm = 1.0;  ///< tolerance for a marker to be visible

}  // namespace

MarkerLabels::MarkerLabels(SceneView& view) : QWidget(&view), view_(view), theme_(theme(ThemeKind::kLight)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  view.installEventFilter(this);
  connect(&view, &SceneView::cameraChanged, this, qOverload<>(&QWidget::update));
  resize(view.size());
}

void MarkerLabels::setMarkers(std::shared_ptr<const Scene> scene, std::vector<OrganMarker> markers,
                              int chosen) {
  scene_ = std::move(scene);
  markers_ = std::move(markers);
  chosen_ = chosen;
  update();
}

void MarkerLabels::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

bool MarkerLabels::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    resize(view_.size());
    raise();
  }
  return false;
}

QPointF MarkerLabels::pixelOf(const OrganMarker& marker) const {
  return view_.camera().pixel(toView(marker.position_m), QSizeF(view_.size()));
}

bool MarkerLabels::isHidden(const OrganMarker& marker) const {
  const QVector3D eye = view_.camera().position();
  const QVector3D way = toView(marker.position_m) - eye;
  const std::optional<SightHit> hit = sightHit(scene_->mesh, {eye, way.normalized()});
  return hit && hit->distance_mm < static_cast<double>(way.length()) - kSkinThickness_mm;
}

void MarkerLabels::paintEvent(QPaintEvent*) {
  if (scene_ == nullptr || !view_.draws()) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPointSizeF(kSmallText_pt);
  font.setBold(true);
  painter.setFont(font);
  const auto draw = [&](const OrganMarker& marker) {
    const bool chosen = marker.number == chosen_;
    const QRectF disc(pixelOf(marker) - QPointF(kLabelRadius_px, kLabelRadius_px),
                      QSizeF(2.0 * kLabelRadius_px, 2.0 * kLabelRadius_px));
    const bool hidden = isHidden(marker) && !chosen;
    painter.setOpacity(hidden ? kHiddenShare : 1.0);
    painter.setPen(QPen(theme_.accent, 2.0));
    painter.setBrush(chosen ? theme_.accent : theme_.surface);
    painter.drawEllipse(disc);
    painter.setOpacity(hidden ? kHiddenNumber : 1.0);
    painter.setPen(chosen ? theme_.onAccent : theme_.text);
    painter.drawText(disc, Qt::AlignCenter, QString::number(marker.number));
  };
  for (const OrganMarker& marker : markers_) {
    if (marker.number != chosen_) {
      draw(marker);
    }
  }
  for (const OrganMarker& marker : markers_) {  // the current one on top
    if (marker.number == chosen_) {
      draw(marker);
    }
  }
}

}  // namespace torsio::gui
