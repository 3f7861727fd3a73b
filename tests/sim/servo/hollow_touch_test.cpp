// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tool meets the shipped hollow organs as they lie at their largest twist.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/servo/tool_touch.h"
#include "tests/support/shipped_hollow_organs.h"

namespace torsio {
namespace {

using testing::smoothAt;
using testing::twistedOrgan;

class HollowTouch : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowTouch, FindsTheTriangleThatATipLiesOn) {
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
