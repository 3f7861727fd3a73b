// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QQuick3DGeometry>

#include "app/gui/scene/organ_surface.h"

namespace torsio::gui {

/// The organ's skin in the scene graph; its vertices are written anew whenever the tissue moves. GUI thread.
class OrganGeometry : public QQuick3DGeometry {
  Q_OBJECT

 public:
  OrganGeometry();
  /// Another organ: triangles and vertices.
  void setSurface(const OrganSurface& surface);
  /// The same organ, moved.
  void updateVertices(const OrganSurface& surface);
};

/// The organ's edges as thin lines, lifted off the skin so that they do not flicker. GUI thread.
class WireGeometry : public QQuick3DGeometry {
  Q_OBJECT

 public:
  WireGeometry();
  void setSurface(const OrganSurface& surface);
  void updateVertices(const OrganSurface& surface);
};

}  // namespace torsio::gui
