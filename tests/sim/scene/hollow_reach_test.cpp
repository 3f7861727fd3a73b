// SPDX-License-Identifier: GPL-3.0-or-later
// How far the pieces of the shipped hollow organs' surfaces reach, at every angle and pressure of a trial.
// What a query of a hollow organ costs, and what its set-up gives twice; times are those of
// torsio_bench_hollow.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "tests/support/allocation_count.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

Scene shipped(const std::string& id) {
  return testing::shippedScene(id, "detorse");
}

/// The states that are looked at: every 15 degrees both ways up to the largest twist, at four pressures.
std::vector<OrganState> statesOf(const Scene& scene) {
  constexpr double kStep_rad = radians(15.0);
  const double most_rad = scene.hollow->detorsion().start.most_rad;
  std::vector<OrganState> states;
  for (int i = 0; kStep_rad * i <= most_rad; ++i) {
    for (const double way : {1.0, -1.0}) {
      for (const double share : {1.0, 0.5, 0.1, 0.0}) {
        OrganState lies = scene.stateAt(way * kStep_rad * i);
        lies.hollow.reading.pressure_Pa *= share;
        states.push_back(lies);
      }
    }
  }
  return states;
}

class HollowReachOf : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowReachOf, NoVertexLeavesTheBoundOfItsPatch) {
  const Scene scene = shipped(GetParam());
  const SurfacePatches& patches = scene.collision.patches();
  const HollowReach& reach = scene.hollow->reach();
  ASSERT_FALSE(reach.empty());
  std::vector<Vec3> moved_m(scene.mesh.vertices_m.size());
  double told_m = 0.0;
  double true_m = 0.0;

  for (const OrganState& lies : statesOf(scene)) {
    const HollowMap map(scene.lattice(), *scene.hollow, lies);
    std::transform(scene.hollow->vertices().begin(), scene.hollow->vertices().end(), moved_m.begin(),
                   [&map](const TwistVertex& vertex) { return map.vertex(vertex); });
    const auto farthest_m = [&](const SurfacePatches::Patch& patch, std::uint32_t seed) {
      double far_m = 0.0;
      for (const std::uint32_t vertex : patches.vertices(patch)) {
        far_m = std::max(far_m, norm(moved_m[vertex] - moved_m[seed]));
      }
      return far_m;
    };
    for (std::size_t g = 0; g < patches.groups().size(); ++g) {
      const SurfacePatches::Group& group = patches.groups()[g];
      double groupFar_m = 0.0;
      for (std::size_t p = group.firstPatch; p < group.firstPatch + group.patchCount; ++p) {
        const SurfacePatches::Patch& patch = patches.patches()[p];
        const double far_m = farthest_m(patch, patch.seed);
        ASSERT_LE(far_m, reach.patch_m(p, map)) << "patch " << p << " at " << lies.twist.graspAngle_rad;
        told_m += reach.patch_m(p, map);
        true_m += far_m;
        groupFar_m = std::max(groupFar_m, farthest_m(patch, group.seed));
      }
      ASSERT_LE(groupFar_m, reach.group_m(g, map)) << "group " << g << " at " << lies.twist.graspAngle_rad;
    }
  }

  EXPECT_LT(told_m, 1.6 * true_m);  // and the bounds are narrow enough to be of use
}

INSTANTIATE_TEST_SUITE_P(ShippedOrgans, HollowReachOf,
                         ::testing::Values("gastric-mesentero-axial", "gastric-organo-axial", "midgut",
                                           "sigmoid", "small-bowel-loop", "testis"));

Scene hollowScene(const std::string& id) {
  return testing::shippedScene(id, "detorse");
}

class HollowOrganCost : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowOrganCost, QueriesAllocateNothing) {
  const Scene scene = hollowScene(GetParam());
  double sum = 0.0;
  unsigned state = 1;
  const auto allocated = testing::allocationCount();

  for (int k = 0; k < 4000; ++k) {
    state = state * 1664525U + 1013904223U;  // angles and pressures in no order
    const double share = static_cast<double>(state >> 8U) / 16777216.0;
    const double pressure_Pa = scene.hollow->detorsion().wall.pressure_Pa * (1.0 - share);
    sum += scene.hollow->torque_Nm(8.0 * share - 4.0, pressure_Pa);
  }

  EXPECT_EQ(testing::allocationCount(), allocated);
  EXPECT_NE(sum, 0.0);
}

TEST_P(HollowOrganCost, ASecondSetUpGivesTheSameOrgan) {
  const Scene scene = hollowScene(GetParam());
  const HollowOrgan::Parts parts{.lattice = &scene.lattice(),
                                 .shearModulus_Pa = scene.model.material().shearModulus_Pa,
                                 .graspArc = scene.pattern.graspArc,
                                 .detorsion = *scene.pattern.detorsion};

  const HollowOrgan organ(parts);

  EXPECT_EQ(organ.basePeak_Nm(), scene.hollow->basePeak_Nm());
}

INSTANTIATE_TEST_SUITE_P(ShippedOrgans, HollowOrganCost,
                         ::testing::Values("gastric-mesentero-axial", "gastric-organo-axial", "midgut",
                                           "sigmoid", "small-bowel-loop", "testis"));

}  // namespace
}  // namespace torsio
