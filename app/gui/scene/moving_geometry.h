// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QQuick3DGeometry>

namespace torsio::gui {

/// A mesh whose vertices are written anew while its triangles stay. Qt Quick tells the model of every change
/// while it is being drawn already, and the model answers by asking for one more frame that shows the same;
/// here it is told of new shapes only. GUI thread.
class MovingGeometry : public QQuick3DGeometry {
  Q_OBJECT

 protected:
  /// Other triangles, another number of vertices: the model has to know. Call it beside setIndexData().
  void reshape() noexcept { reshaped_ = true; }
  QSSGRenderGraphObject* updateSpatialNode(QSSGRenderGraphObject* node) override;

 private:
  bool reshaped_ = true;
};

}  // namespace torsio::gui
