// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/gui/scene/scene_view.h"
#include "app/services/recording/async_model_playback.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// Lets the view of a scene draw what an asynchronous model makes of the organ; returns where that model
/// puts it. Null where the servo answers alone: nothing has changed.
[[nodiscard]] std::shared_ptr<LatestShape> showAsyncShape(const Scene& scene, ViewScene& view);

}  // namespace torsio::gui
