// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr float kHighest_deg = 89.0F;
constexpr float kZoomPerStep = 0.89F;
constexpr float kMargin = 1.12F;  // distance factor that leaves a margin around a framed ball

float halfAngleTangent() {
  return std::tan(OrbitCamera::kFieldOfView_deg * std::numbers::pi_v<float> / 360.0F);
}

float aspect(const QSizeF& size) {
  return static_cast<float>(std::max(size.width(), 1.0) / std::max(size.height(), 1.0));
}

constexpr double kKeyOrbit_px = 24.0;
constexpr double kNotch = 120.0;  ///< of the wheel, eighths of a degree

}  // namespace

void OrbitCamera::frame(const QVector3D& centre, float radius, const QSizeF& size) {
  target_ = centre;
  radius_ = std::max(radius, 1.0F);
  const float narrow = std::min(1.0F, aspect(size));
  const float halfAngle = std::atan(halfAngleTangent() * narrow);
  distance_ = kMargin * radius_ / std::sin(halfAngle);
}

void OrbitCamera::look(ViewPreset preset) {
  lookFrom(preset == ViewPreset::kSide ? 90.0F : 0.0F, preset == ViewPreset::kTop ? kHighest_deg : 0.0F);
}

void OrbitCamera::lookFrom(float azimuth_deg, float elevation_deg) {
  azimuth_deg_ = azimuth_deg;
  elevation_deg_ = std::clamp(elevation_deg, -kHighest_deg, kHighest_deg);
}

void OrbitCamera::orbit(const QPointF& drag) {
  azimuth_deg_ = std::remainder(azimuth_deg_ - kDegreesPerPixel * static_cast<float>(drag.x()), 360.0F);
  elevation_deg_ = std::clamp(elevation_deg_ + kDegreesPerPixel * static_cast<float>(drag.y()), -kHighest_deg,
                              kHighest_deg);
}

void OrbitCamera::pan(const QPointF& drag, double height) {
  const float mmPerPixel = 2.0F * distance_ * halfAngleTangent() / static_cast<float>(std::max(height, 1.0));
  target_ -= (right() * static_cast<float>(drag.x()) - up() * static_cast<float>(drag.y())) * mmPerPixel;
}

void OrbitCamera::zoom(double steps) {
  distance_ *= std::pow(kZoomPerStep, static_cast<float>(steps));
  distance_ = std::clamp(distance_, 0.5F * radius_, 20.0F * radius_);
}

QQuaternion OrbitCamera::rotation() const {
  return QQuaternion::fromAxisAndAngle(0, 1, 0, azimuth_deg_) *
         QQuaternion::fromAxisAndAngle(1, 0, 0, -elevation_deg_);
}

QVector3D OrbitCamera::right() const {
  return rotation().rotatedVector({1, 0, 0});
}

QVector3D OrbitCamera::up() const {
  return rotation().rotatedVector({0, 1, 0});
}

QVector3D OrbitCamera::forward() const {
  return rotation().rotatedVector({0, 0, -1});
}

QVector3D OrbitCamera::position() const {
  return target_ - forward() * distance_;
}

ViewRay OrbitCamera::ray(const QPointF& pixel, const QSizeF& size) const {
  const float x = static_cast<float>(2.0 * pixel.x() / std::max(size.width(), 1.0) - 1.0);
  const float y = static_cast<float>(1.0 - 2.0 * pixel.y() / std::max(size.height(), 1.0));
  const float t = halfAngleTangent();
  const QVector3D direction = forward() + right() * (x * t * aspect(size)) + up() * (y * t);
  return {position(), direction.normalized()};
}

QPointF OrbitCamera::pixel(const QVector3D& point, const QSizeF& size) const {
  const QVector3D offset = point - position();
  const float reach = std::max(QVector3D::dotProduct(offset, forward()), 1e-3F) * halfAngleTangent();
  const float x = QVector3D::dotProduct(offset, right()) / (reach * aspect(size));
  const float y = QVector3D::dotProduct(offset, up()) / reach;
  return {0.5 * (1.0 + static_cast<double>(x)) * size.width(),
          0.5 * (1.0 - static_cast<double>(y)) * size.height()};
}

float OrbitCamera::depth(const QVector3D& point) const {
  return QVector3D::dotProduct(point - position(), forward());
}

QVector3D OrbitCamera::atDepth(const QPointF& pixel, float depth, const QSizeF& size) const {
  const ViewRay line = ray(pixel, size);
  return line.origin + line.direction * (depth / QVector3D::dotProduct(line.direction, forward()));
}

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

ViewOverlay::ViewOverlay(SceneView& view) : QWidget(&view), view_(view), theme_(&theme(ThemeKind::kLight)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  view.installEventFilter(this);
  connect(&view, &SceneView::cameraChanged, this, qOverload<>(&QWidget::update));
  resize(view.size());
}

void ViewOverlay::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

bool ViewOverlay::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    resize(view_.size());
    raise();
  }
  return false;
}

QPointF ViewOverlay::pixelOf(const Vec3& place_m) const {
  return view_.camera().pixel(toView(place_m), QSizeF(view_.size()));
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
