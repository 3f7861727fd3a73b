// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/async_view.h"

namespace torsio::gui {

std::shared_ptr<LatestShape> showAsyncShape(const Scene& scene, ViewScene& view) {
  if (!runsAsync(scene.tissue)) {
    return nullptr;
  }
  auto newest = std::make_shared<LatestShape>(scene);
  view.shapeNumber = [newest] { return newest->number(); };
  view.shape = [newest](std::span<Vec3> out_m) { newest->vertices(out_m); };
  return newest;
}

}  // namespace torsio::gui
