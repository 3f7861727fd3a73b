// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QPointF>
#include <QQuaternion>
#include <QSizeF>
#include <QVector3D>
#include <QWidget>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

/// A ray in the view frame, mm.
struct ViewRay {
  QVector3D origin;
  QVector3D direction;  ///< unit
};

/// View directions with anatomical names: front is the view of a surgeon at the patient's feet.
enum class ViewPreset { kFront, kSide, kTop };

/// A camera that orbits a target point. Plain value in the view frame (mm, y up); converts between pixels and
/// points, so that pointers need no scene graph.
class OrbitCamera {
 public:
  static constexpr float kFieldOfView_deg = 32.0F;
  static constexpr float kDegreesPerPixel = 0.35F;  ///< while orbiting

  /// Frames a ball so that it fills `size` up to a margin.
  void frame(const QVector3D& centre, float radius, const QSizeF& size);
  void look(ViewPreset preset);
  /// Sets the direction: `azimuth_deg` about the organ from the front towards the patient's left,
  /// `elevation_deg` from below (-89) to above (89).
  void lookFrom(float azimuth_deg, float elevation_deg);
  /// Orbits by a drag, pixels.
  void orbit(const QPointF& drag);
  /// Moves target and camera by a drag in a view of `height`, pixels.
  void pan(const QPointF& drag, double height);
  /// Zooms by steps of a wheel; positive: nearer.
  void zoom(double steps);

  [[nodiscard]] QVector3D position() const;
  [[nodiscard]] QQuaternion rotation() const;
  [[nodiscard]] QVector3D right() const;
  [[nodiscard]] QVector3D up() const;
  [[nodiscard]] QVector3D forward() const;
  [[nodiscard]] float distance() const noexcept { return distance_; }
  [[nodiscard]] const QVector3D& target() const noexcept { return target_; }

  /// Returns the ray through a pixel of a view of `size` pixels.
  [[nodiscard]] ViewRay ray(const QPointF& pixel, const QSizeF& size) const;
  /// Returns the pixel of a point in front of the camera.
  [[nodiscard]] QPointF pixel(const QVector3D& point, const QSizeF& size) const;
  /// Returns the distance of a point along the viewing direction.
  [[nodiscard]] float depth(const QVector3D& point) const;
  /// Returns the point on a pixel's ray at this depth along the viewing direction.
  [[nodiscard]] QVector3D atDepth(const QPointF& pixel, float depth, const QSizeF& size) const;

 private:
  QVector3D target_;
  float radius_ = 100.0F;
  float distance_ = 500.0F;
  float azimuth_deg_ = 0.0F;
  float elevation_deg_ = 0.0F;
};

class SceneView;
struct Theme;

/// Turns the camera of a scene view without an instrument: drag or arrow keys turn it, wheel or + and - zoom.
/// Reports clicks without drag. Owned by the view.
class ViewTurn : public QObject {
  Q_OBJECT

 public:
  explicit ViewTurn(SceneView& view);

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  /// The camera has moved.
  void turned();
  /// The left button was clicked at a pixel of the view.
  void clicked(const QPointF& pixel);

 private:
  bool keyPressed(int key);
  void orbit(const QPointF& drag);
  void zoom(double steps);

  SceneView& view_;
  std::optional<QPointF> pressed_;  // where a button was pressed
  QPointF last_;
  bool dragged_ = false;
};

/// Covers a scene view and follows its size and camera; ignores the mouse. GUI thread.
class ViewOverlay : public QWidget {
  Q_OBJECT

 public:
  /// `view`: its parent.
  explicit ViewOverlay(SceneView& view);
  void setTheme(const Theme& theme);
  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  [[nodiscard]] const SceneView& view() const noexcept { return view_; }
  [[nodiscard]] const Theme& colours() const noexcept { return *theme_; }
  /// Returns the pixel of a place in the world frame.
  [[nodiscard]] QPointF pixelOf(const Vec3& place_m) const;

 private:
  SceneView& view_;
  const Theme* theme_;
};

/// The first point of a mesh on a line of sight.
struct SightHit {
  std::uint32_t face = 0;
  std::array<double, 3> barycentric{};
  double distance_mm = 0.0;  ///< from the ray's origin
};

/// Finds the first intersection of a ray of the view frame with a mesh at rest; empty: none. Tests every
/// triangle: under a millisecond for twenty thousand.
[[nodiscard]] std::optional<SightHit> sightHit(const TriangleMesh& mesh, const ViewRay& ray);

}  // namespace torsio::gui
