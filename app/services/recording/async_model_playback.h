// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/services/recording/async_model_worker.h"
#include "sim/core/live_types.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Recomputes the organ's shape when playing a recording that was made with an asynchronous model. Forces,
/// angles and times come from the recording; only the shape is computed again, at this machine's rate, by the
/// same model moved to the recorded angles.
class AsyncModelPlayback {
 public:
  /// Starts the model for a playback of `scene`; its shapes go to `shape`.
  AsyncModelPlayback(std::shared_ptr<const Scene> scene, std::shared_ptr<LatestShape> shape);
  /// Moves the model to the displayed state. One thread.
  void follow(const LiveState& shown) noexcept;

 private:
  AsyncLink link_;
  AsyncModelWorker worker_;
};

}  // namespace torsio
