// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/gui/scene/scene_view.h"
#include "app/services/recording/async_model_worker.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// Makes the scene's view draw the shapes of an asynchronous model; returns where that model stores them.
/// Null if there is no such model: nothing has changed.
[[nodiscard]] std::shared_ptr<LatestShape> showAsyncShape(const Scene& scene, ViewScene& view);

}  // namespace torsio::gui
