// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/async_model_playback.h"

#include <utility>

namespace torsio {

AsyncModelPlayback::AsyncModelPlayback(std::shared_ptr<const Scene> scene, std::shared_ptr<LatestShape> shape)
    : worker_(std::move(scene), link_, std::move(shape)) {
  worker_.start();
}

void AsyncModelPlayback::follow(const LiveState& shown) noexcept {
  link_.questions.publish({1, shown.response.graspArc_m, shown.response.angle_rad});
}

}  // namespace torsio
