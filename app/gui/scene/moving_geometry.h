// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QQuick3DGeometry>

namespace torsio::gui {

/// A mesh with changing vertices and fixed triangles. Qt Quick notifies the model of every change during
/// drawing, and the model then requests one more, identical frame; this class only notifies it of new
/// topology. GUI thread.
class MovingGeometry : public QQuick3DGeometry {
  Q_OBJECT

 protected:
  /// Marks a change of triangles or vertex count, of which the model must be notified. Call it with
  /// setIndexData().
  void reshape() noexcept { reshaped_ = true; }
  QSSGRenderGraphObject* updateSpatialNode(QSSGRenderGraphObject* node) override;

 private:
  bool reshaped_ = true;
};

}  // namespace torsio::gui
