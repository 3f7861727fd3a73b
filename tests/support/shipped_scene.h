// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
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
  if (scene.hollow->swing() != nullptr) {
    std::vector<Vec3> swung_m(scene.mesh.vertices_m.size());
    scene.deform(lies, swung_m);
    return swung_m;
  }
  const HollowMap map(scene.lattice(), *scene.hollow, lies);
  std::vector<Vec3> moved_m;
  for (const TwistVertex& vertex : scene.hollow->vertices()) {
    moved_m.push_back(map.vertex(vertex));
  }
  return moved_m;
}

/// Copies shipped data files, except organs, to a test's own folder, to change one of them.
class CopiedSceneFiles : public ::testing::Test {
 protected:
  /// `names`: relative to the folder of the shipped data.
  explicit CopiedSceneFiles(std::initializer_list<const char*> names) {
    namespace fs = std::filesystem;
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    assets_ = fs::path(::testing::TempDir()) / (std::string(test->test_suite_name()) + "_" + test->name());
    fs::remove_all(assets_);
    for (const char* name : names) {
      fs::create_directories((assets_ / name).parent_path());
      fs::copy_file(fs::path(TORSIO_SOURCE_DIR) / "assets" / name, assets_ / name);
    }
  }
  ~CopiedSceneFiles() override { std::filesystem::remove_all(assets_); }

  std::filesystem::path assets_;
};

}  // namespace torsio::testing
