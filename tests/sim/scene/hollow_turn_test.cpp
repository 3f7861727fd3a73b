// SPDX-License-Identifier: GPL-3.0-or-later
// How the shipped hollow organs go round: rigidly in the mobile part, nowhere through themselves.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/angle.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"
#include "sim/tissue/rod/fold_check.h"

namespace torsio {
namespace {

Scene twistedOrgan(const std::string& id) {
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = id;
  request.pattern = "detorse";
  return loadScene(request);
}

std::vector<Vec3> smoothAt(const Scene& scene, const OrganState& lies) {
  const HollowMap map(scene.model, *scene.hollow, lies);
  std::vector<Vec3> moved_m;
  for (const TwistVertex& vertex : scene.model.tables().vertices) {
    moved_m.push_back(map.vertex(vertex));
  }
  return moved_m;
}

class HollowTurn : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowTurn, FoldsNoTissueHoweverFarItIsTurned) {
  const Scene scene = twistedOrgan(GetParam());
  const FoldCheck check(scene.mesh, scene.lattice());
  const double most_rad = scene.hollow->detorsion().start.most_rad;

  for (const double angle_rad : {radians(180.0), radians(360.0)}) {
    for (const double way : {1.0, -1.0}) {
      const OrganState lies = scene.stateAt(way * std::min(angle_rad, most_rad));
      const FoldReport report = check.judge(
          smoothAt(scene, lies), [&](const Vec3& rest_m) { return scene.toDeformed_m(rest_m, lies); });

      EXPECT_GT(report.minDeterminant, 0.0) << degrees(angle_rad) * way;
      // Long triangles of a drawn neck; of the organ turned frame by frame hundreds crossed.
      EXPECT_LE(report.crossings, 12U) << degrees(angle_rad) * way;
    }
  }
}

TEST_P(HollowTurn, TheMobilePartKeepsItsShapeAndItsDistanceFromItsLine) {
  const Scene scene = twistedOrgan(GetParam());
  const OrganState lies = scene.stateAt(radians(130.0));
  const std::vector<Vec3> moved_m = smoothAt(scene, lies);
  const TwistLine& line = scene.hollow->line();
  const auto arm_m = [&](const Vec3& x) { return norm(cross(line.direction, x - line.point_m)); };

  const std::vector<TwistVertex>& vertices = scene.model.tables().vertices;
  std::size_t first = vertices.size();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (scene.hollow->turningPlace(vertices[i].arc_m, vertices[i].rest_m).span >= 0) {
      continue;
    }
    first = std::min(first, i);
    const double before_m = norm(vertices[i].rest_m - vertices[first].rest_m);
    EXPECT_NEAR(norm(moved_m[i] - moved_m[first]), before_m, 1e-12) << i;
    EXPECT_NEAR(arm_m(moved_m[i]), arm_m(vertices[i].rest_m), 1e-12) << i;
  }
  EXPECT_LT(first, vertices.size());
}

TEST_P(HollowTurn, FindsItsWayBackFromEveryVertex) {
  const Scene scene = twistedOrgan(GetParam());
  const OrganState lies = scene.stateAt(radians(150.0));
  const HollowMap map(scene.model, *scene.hollow, lies);

  const std::vector<TwistVertex>& vertices = scene.model.tables().vertices;
  for (std::size_t i = 0; i < vertices.size(); i += 5) {
    EXPECT_LT(norm(map.backward(map.forward(vertices[i].rest_m)) - vertices[i].rest_m), 1e-6) << i;
  }
}

TEST_P(HollowTurn, AtRestNoVertexMovesByABit) {
  const Scene scene = twistedOrgan(GetParam());
  const TwistVertex& vertex = scene.model.tables().vertices.front();
  const HollowOrgan& organ = *scene.hollow;

  for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double arc_m = share * organ.length_m();
    const HollowOrgan::Place place = organ.turningPlace(arc_m, vertex.rest_m);
    EXPECT_EQ(organ.moved(vertex.rest_m, vertex.line, place, {}, {}), vertex.rest_m);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, HollowTurn,
                         ::testing::Values("small-bowel-loop", "gastric-organo-axial",
                                           "gastric-mesentero-axial", "sigmoid", "midgut", "testis"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(HollowLine, OnlyALoopWithLimbsSideBySideIsWound) {
  EXPECT_TRUE(twistedOrgan("sigmoid").hollow->wound());
  EXPECT_FALSE(twistedOrgan("small-bowel-loop").hollow->wound());
}

}  // namespace
}  // namespace torsio
