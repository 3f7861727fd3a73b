// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/gui/scene/scene_view.h"
#include "app/services/recording/async_model_worker.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// Makes the scene's view draw the shapes of an asynchronous model; returns where that model stores them.
/// Null if there is no such model: nothing has changed.
[[nodiscard]] std::shared_ptr<LatestShape> showAsyncShape(const Scene& scene, ViewScene& view);

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
