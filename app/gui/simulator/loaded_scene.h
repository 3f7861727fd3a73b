// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/async_view.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// A scene together with what the view draws of it.
struct LoadedScene {
  std::shared_ptr<const Scene> scene;
  ViewScene view;
  std::shared_ptr<LatestShape> shape{};  ///< where an asynchronous model answers; else null
};

/// Reads a scene. Called in a worker thread; throws Error.
using SceneLoader = std::function<LoadedScene(const SceneRequest&)>;
[[nodiscard]] LoadedScene loadSceneForView(const SceneRequest& request);
/// Reads the scene of a recording by `loader`, in the formulation whose hashes are the recorded ones. Throws
/// Error{kVerifyFailed}: neither is.
[[nodiscard]] LoadedScene loadRecordedScene(const SceneLoader& loader, SceneRequest request,
                                            const TrialHeader& header);

}  // namespace torsio::gui
