// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QQuaternion>
#include <QSizeF>
#include <QVector3D>

namespace torsio::gui {

/// A half-line in the view frame, millimetres.
struct ViewRay {
  QVector3D origin;
  QVector3D direction;  ///< unit
};

/// From where an organ is looked at. Names as in anatomy: front is what a surgeon at the patient's feet sees.
enum class ViewPreset { kFront, kSide, kTop };

/// A camera that turns about a target point. Plain value in the view frame (millimetres, y up); it knows how
/// pixels and points correspond, so that the pointer needs no scene graph.
class OrbitCamera {
 public:
  static constexpr float kFieldOfView_deg = 32.0F;
  static constexpr float kDegreesPerPixel = 0.35F;  ///< of an orbiting drag

  /// Looks at a ball so that it fills `size` up to a margin.
  void frame(const QVector3D& centre, float radius, const QSizeF& size);
  void look(ViewPreset preset);
  /// Looks from a side: `azimuth_deg` round the organ from the front towards the patient's left,
  /// `elevation_deg` from below (-89) to above (89).
  void lookFrom(float azimuth_deg, float elevation_deg);
  /// Turns by a drag of so many pixels.
  void orbit(const QPointF& drag);
  /// Moves target and camera with a drag of so many pixels in a view of `height` pixels.
  void pan(const QPointF& drag, double height);
  /// One step is one notch of a wheel; positive comes nearer.
  void zoom(double steps);

  [[nodiscard]] QVector3D position() const;
  [[nodiscard]] QQuaternion rotation() const;
  [[nodiscard]] QVector3D right() const;
  [[nodiscard]] QVector3D up() const;
  [[nodiscard]] QVector3D forward() const;
  [[nodiscard]] float distance() const noexcept { return distance_; }
  [[nodiscard]] const QVector3D& target() const noexcept { return target_; }

  /// The half-line through a pixel of a view of `size` pixels.
  [[nodiscard]] ViewRay ray(const QPointF& pixel, const QSizeF& size) const;
  /// The pixel of a point in front of the camera.
  [[nodiscard]] QPointF pixel(const QVector3D& point, const QSizeF& size) const;
  /// Distance of a point from the camera along its line of sight.
  [[nodiscard]] float depth(const QVector3D& point) const;
  /// The point on a pixel's ray at such a depth along the line of sight.
  [[nodiscard]] QVector3D atDepth(const QPointF& pixel, float depth, const QSizeF& size) const;

 private:
  QVector3D target_;
  float radius_ = 100.0F;
  float distance_ = 500.0F;
  float azimuth_deg_ = 0.0F;
  float elevation_deg_ = 0.0F;
};

}  // namespace torsio::gui
