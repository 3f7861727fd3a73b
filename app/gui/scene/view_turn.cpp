// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/view_turn.h"

#include <cmath>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"

namespace torsio::gui {

namespace {

constexpr double kKeyOrbit_px = 24.0;
constexpr double kNotch = 120.0;  ///< of the wheel, eighths of a degree

}  // namespace

ViewTurn::ViewTurn(SceneView& view) : QObject(&view), view_(view) {
  view_.setFocusPolicy(Qt::StrongFocus);
  view_.installEventFilter(this);
}

bool ViewTurn::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      pressed_ = last_ = static_cast<QMouseEvent*>(event)->position();
      dragged_ = false;
      view_.setFocus(Qt::MouseFocusReason);
      return true;
    case QEvent::MouseMove: {
      const QPointF here = static_cast<QMouseEvent*>(event)->position();
      dragged_ =
          dragged_ || (pressed_ && (here - *pressed_).manhattanLength() >= QApplication::startDragDistance());
      if (pressed_ && dragged_) {
        orbit(here - last_);
        last_ = here;
      }
      return true;
    }
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (pressed_ && !dragged_ && mouse->button() == Qt::LeftButton) {
        Q_EMIT clicked(mouse->position());
      }
      pressed_.reset();
      return true;
    }
    case QEvent::Wheel:
      zoom(static_cast<QWheelEvent*>(event)->angleDelta().y() / kNotch);
      return true;
    case QEvent::KeyPress:
      return keyPressed(static_cast<QKeyEvent*>(event)->key());
    default:
      return false;
  }
}

bool ViewTurn::keyPressed(int key) {
  switch (key) {
    case Qt::Key_Left:
      orbit({-kKeyOrbit_px, 0.0});
      return true;
    case Qt::Key_Right:
      orbit({kKeyOrbit_px, 0.0});
      return true;
    case Qt::Key_Up:
      orbit({0.0, -kKeyOrbit_px});
      return true;
    case Qt::Key_Down:
      orbit({0.0, kKeyOrbit_px});
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoom(1.0);
      return true;
    case Qt::Key_Minus:
      zoom(-1.0);
      return true;
    default:
      return false;
  }
}

void ViewTurn::orbit(const QPointF& drag) {
  view_.camera().orbit(drag);
  view_.applyCamera();
  Q_EMIT turned();
}

void ViewTurn::zoom(double steps) {
  view_.camera().zoom(steps);
  view_.applyCamera();
  Q_EMIT turned();
}

std::optional<SightHit> sightHit(const TriangleMesh& mesh, const ViewRay& ray) {
  const Vec3 origin = fromView(ray.origin);
  const Vec3 along = fromViewDirection(ray.direction);
  std::optional<SightHit> hit;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corners = mesh.triangles[t];
    // Moeller and Trumbore 1997.
    const Vec3 a = mesh.vertices_m[corners[0]];
    const Vec3 ab = mesh.vertices_m[corners[1]] - a;
    const Vec3 ac = mesh.vertices_m[corners[2]] - a;
    const Vec3 p = cross(along, ac);
    const double determinant = dot(ab, p);
    if (determinant == 0.0) {
      continue;
    }
    const Vec3 from = origin - a;
    const double v = dot(from, p) / determinant;
    const Vec3 q = cross(from, ab);
    const double w = dot(along, q) / determinant;
    const double distance_mm = static_cast<double>(kViewUnitsPerMetre) * dot(ac, q) / determinant;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0 && distance_mm > 0.0 &&
        (!hit || distance_mm < hit->distance_mm)) {
      hit = SightHit{static_cast<std::uint32_t>(t), {1.0 - v - w, v, w}, distance_mm};
    }
  }
  return hit;
}

}  // namespace torsio::gui
