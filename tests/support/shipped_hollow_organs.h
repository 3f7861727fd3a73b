// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "tests/support/shipped_scene.h"

namespace torsio::testing {

/// Returns a shipped hollow organ with its untwisting pattern, loaded once.
inline const Scene& twistedOrgan(const std::string& id) {
  static std::map<std::string, Scene> loaded;
  const auto found = loaded.find(id);
  if (found != loaded.end()) {
    return found->second;
  }
  return loaded.emplace(id, shippedScene(id, "detorse")).first->second;
}

/// Returns its vertices in this state, without the folds of its wall.
inline std::vector<Vec3> smoothAt(const Scene& scene, const OrganState& lies) {
  const HollowMap map(scene.lattice(), *scene.hollow, lies);
  std::vector<Vec3> moved_m;
  for (const TwistVertex& vertex : scene.hollow->vertices()) {
    moved_m.push_back(map.vertex(vertex));
  }
  return moved_m;
}

}  // namespace torsio::testing
