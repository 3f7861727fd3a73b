// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QPointF>

#include "app/gui/scene/orbit_camera.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

class SceneView;

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
