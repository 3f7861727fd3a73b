// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tool meets the shipped hollow organs as they lie at their largest twist.
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/servo/tool_touch.h"

namespace torsio {
namespace {

/// A shipped organ, loaded once.
const Scene& twistedOrgan(const std::string& id) {
  static std::map<std::string, Scene> loaded;
  const auto found = loaded.find(id);
  if (found != loaded.end()) {
    return found->second;
  }
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = id;
  request.pattern = "detorse";
  return loaded.emplace(id, loadScene(request)).first->second;
}

std::vector<Vec3> smoothAt(const Scene& scene, const OrganState& lies) {
  const HollowMap map(scene.lattice(), *scene.hollow, lies);
  std::vector<Vec3> moved_m;
  for (const TwistVertex& vertex : scene.hollow->vertices()) {
    moved_m.push_back(map.vertex(vertex));
  }
  return moved_m;
}

class HollowTouch : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowTouch, MeetsTheVeryTriangleThatATipLiesOn) {
  const Scene& scene = twistedOrgan(GetParam());
  const InitialTwist& start = scene.hollow->detorsion().start;

  for (const double angle_rad : {start.most_rad, -start.most_rad}) {
    const OrganState lies = scene.stateAt(angle_rad);
    const std::vector<Vec3> moved_m = smoothAt(scene, lies);
    int missed = 0;
    double farthest_m = 0.0;
    for (const TriangleMesh::Triangle& t : scene.mesh.triangles) {
      const Vec3 on_m = (moved_m[t[0]] + moved_m[t[1]] + moved_m[t[2]]) / 3.0;
      const double away_m = std::abs(nearestSurface(on_m, scene, lies).distance_m);
      missed += away_m > 1e-9 ? 1 : 0;
      farthest_m = std::max(farthest_m, away_m);
    }
    EXPECT_EQ(missed, 0) << "of " << scene.mesh.triangles.size() << " at " << angle_rad << " rad, by "
                         << 1e3 * farthest_m << " mm";
  }
}

INSTANTIATE_TEST_SUITE_P(ShippedOrgans, HollowTouch,
                         ::testing::Values("gastric-mesentero-axial", "gastric-organo-axial", "midgut",
                                           "sigmoid", "small-bowel-loop", "testis"));

}  // namespace
}  // namespace torsio
