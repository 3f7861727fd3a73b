// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/services/recording/async_model_worker.h"
#include "sim/core/live_types.h"
#include "sim/scene/scene.h"

namespace torsio {

/// The picture of a recording whose hand was answered by an asynchronous model. Forces, angles and times
/// are those of the record; only the shape of the organ is computed again, at the rate of this machine, by
/// the same model led to the recorded angles.
class AsyncModelPlayback {
 public:
  /// Begins to work beside a playback of `scene`, whose shapes go to `shape`.
  AsyncModelPlayback(std::shared_ptr<const Scene> scene, std::shared_ptr<LatestShape> shape);
  /// Leads the model to what is shown now. One thread.
  void follow(const LiveState& shown) noexcept;

 private:
  AsyncLink link_;
  AsyncModelWorker worker_;
};

}  // namespace torsio
