// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/beside_playback.h"

#include <utility>

namespace torsio {

BesidePlayback::BesidePlayback(std::shared_ptr<const Scene> scene, std::shared_ptr<NewestShape> shape)
    : worker_(std::move(scene), link_, std::move(shape)) {
  worker_.start();
}

void BesidePlayback::follow(const LiveState& shown) noexcept {
  link_.questions.publish({1, shown.response.graspArc_m, shown.response.angle_rad});
}

}  // namespace torsio
