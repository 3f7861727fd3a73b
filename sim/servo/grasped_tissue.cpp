// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/grasped_tissue.h"

namespace torsio {

GraspedTissue::Kind GraspedTissue::kindOf(const Scene& scene, std::int64_t tickPeriod_us) {
  if (runsAsync(scene.tissue)) {
    return GraspedAsync(scene, tickPeriod_us);
  }
  if (scene.rod) {
    return GraspedRod(scene, tickPeriod_us);
  }
  if (scene.hollow) {
    return GraspedHollow(scene, tickPeriod_us);
  }
  return GraspedBar(scene, tickPeriod_us);
}

GraspedTissue::GraspedTissue(const Scene& scene, std::int64_t tickPeriod_us)
    : kind_(kindOf(scene, tickPeriod_us)) {}

}  // namespace torsio
