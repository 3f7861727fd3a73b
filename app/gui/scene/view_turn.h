// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QPointF>

#include "app/gui/scene/orbit_camera.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

class SceneView;

/// Turns the camera of a scene view where nothing else is steered: dragging or the arrow keys turn it, the
/// wheel or
/// + and - zoom. A click that does not drag is told. Belongs to the view.
class ViewTurn : public QObject {
  Q_OBJECT

 public:
  explicit ViewTurn(SceneView& view);

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  /// The camera has another place.
  void turned();
  /// The left button was pressed and let go at a pixel of the view.
  void clicked(const QPointF& pixel);

 private:
  bool keyPressed(int key);
  void orbit(const QPointF& drag);
  void zoom(double steps);

  SceneView& view_;
  std::optional<QPointF> pressed_;  // where a button went down
  QPointF last_;
  bool dragged_ = false;
};

/// A point of a mesh that a line of sight meets first.
struct SightHit {
  std::uint32_t face = 0;
  std::array<double, 3> barycentric{};
  double distance_mm = 0.0;  ///< from the ray's origin
};

/// Finds where a ray of the view frame meets a mesh at rest first; empty: nowhere. Looks at every triangle:
/// under a millisecond for twenty thousand.
[[nodiscard]] std::optional<SightHit> sightHit(const TriangleMesh& mesh, const ViewRay& ray);

}  // namespace torsio::gui
