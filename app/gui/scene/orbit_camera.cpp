// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

}  // namespace torsio::gui
