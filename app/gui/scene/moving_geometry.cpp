// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/moving_geometry.h"

#include <utility>

#include <QSignalBlocker>

namespace torsio::gui {

QSSGRenderGraphObject* MovingGeometry::updateSpatialNode(QSSGRenderGraphObject* node) {
  QSignalBlocker quiet(this);
  if (std::exchange(reshaped_, false) || node == nullptr) {
    quiet.unblock();
  }
  return QQuick3DGeometry::updateSpatialNode(node);
}

}  // namespace torsio::gui
