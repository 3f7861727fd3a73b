// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "sim/scene/scene.h"

namespace torsio::testing {

/// Returns the request for a scene of assets/scenes; default pattern: its first one.
inline SceneRequest shippedRequest(const std::string& id = "forearm", const std::string& pattern = {}) {
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = id;
  request.pattern = pattern;
  return request;
}

inline Scene shippedScene(const std::string& id = "forearm", const std::string& pattern = {}) {
  return loadScene(shippedRequest(id, pattern));
}

}  // namespace torsio::testing
