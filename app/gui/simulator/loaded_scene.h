// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/async_view.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// A scene with the data of its view.
struct LoadedScene {
  std::shared_ptr<const Scene> scene;
  ViewScene view;
  std::shared_ptr<LatestShape> shape{};  ///< where an asynchronous model stores its shape; otherwise null
};

/// Loads a scene in a worker thread; throws Error.
using SceneLoader = std::function<LoadedScene(const SceneRequest&)>;
[[nodiscard]] LoadedScene loadSceneForView(const SceneRequest& request);
/// Loads the scene of a recording with `loader`, in the formulation with the recorded hashes. Throws
/// Error{kVerifyFailed} if neither matches.
[[nodiscard]] LoadedScene loadRecordedScene(const SceneLoader& loader, SceneRequest request,
                                            const TrialHeader& header);

}  // namespace torsio::gui
