// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/target_reach.h"

#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

/// Returns whether the pattern's own target, which its scene guarantees, is at least as far in the same
/// direction.
bool withinPattern(const TwistPattern& pattern, double target_rad) {
  return std::abs(target_rad) <= std::abs(pattern.targetAngle_rad) &&
         (target_rad < 0.0) == (pattern.targetAngle_rad < 0.0);
}

double turnedTowards_rad(const SceneRequest& request, double target_rad) {
  const Scene scene = loadScene(request);
  if (!scene.rod) {
    return target_rad;
  }
  const double reached_rad = scene.rod->pointAt(target_rad).angle_rad;
  constexpr double kRounding = 1e-9;
  return std::abs(reached_rad - target_rad) < kRounding ? target_rad : reached_rad;
}

}  // namespace

double targetReach_rad(const std::filesystem::path& assets, const std::string& sceneId,
                       const std::string& patternId, double target_rad) {
  static std::mutex mutex;
  static std::map<std::tuple<std::filesystem::path, std::string, std::string, double>, double> known;
  for (const PatternDescription& one : readSceneFile(assets, sceneId).patterns) {
    if (one.pattern.id == patternId && (!one.pattern.task || withinPattern(one.pattern, target_rad))) {
      return target_rad;
    }
  }
  const std::scoped_lock lock(mutex);
  const auto [entry, isNew] = known.try_emplace({assets, sceneId, patternId, target_rad}, target_rad);
  if (isNew) {
    SceneRequest request;
    request.assets = assets;
    request.id = sceneId;
    request.pattern = patternId;
    try {
      entry->second = turnedTowards_rad(request, target_rad);
    } catch (...) {
      known.erase(entry);
      throw;
    }
  }
  return entry->second;
}

}  // namespace torsio
