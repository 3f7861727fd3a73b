// SPDX-License-Identifier: GPL-3.0-or-later
// The instrument against organs that are twisted: the answer of the tick against FCL and against every
// triangle of the fully moved mesh.
// Where a tool meets the shipped hollow organs as they lie at their largest twist.
#include "sim/servo/tool_touch.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "assessment/domain/people/person.h"
#include "sim/core/angle.h"
#include "sim/core/file_io.h"
#include "sim/core/random.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/support/fcl_model.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

/// FCL's own accuracy for a capsule against a mesh (LIBCCD's tolerance), and the stated accuracy of the map.
constexpr double kFcl_m = 1e-5;
constexpr double kTouchRounding_m = 1e-12;

/// The surface as a tool meets it: of a wrung wall without the folds that a view draws.
TriangleMesh moved(const Scene& scene, const OrganState& organ) {
  TriangleMesh mesh = scene.mesh;
  if (scene.hollow) {
    mesh.vertices_m = testing::smoothAt(scene, organ);
  } else {
    scene.deform(organ, mesh.vertices_m);
  }
  return mesh;
}

/// What is touched, with nothing remembered.
ToolTouch touchFresh(const ToolShape& shape, const Scene& scene, const OrganState& organ, bool holding) {
  TouchMemory nothing;
  return touchTool(shape, scene, organ, holding, nothing);
}

Quat anyTurn(Random& random) {
  return normalized(Quat{random.normal(), random.normal(), random.normal(), random.normal()});
}

/// Tools whose tip lies up to 20 mm outside or 8 mm inside somewhere on the moved surface.
std::vector<ToolState> toolsNear(const TriangleMesh& mesh, const CollisionMesh& surface, int count) {
  Random random(5);
  std::vector<ToolState> tools(static_cast<std::size_t>(count));
  for (ToolState& tool : tools) {
    const Vec3& v = mesh.vertices_m[random.bounded(mesh.vertices_m.size())];
    const Vec3 normal = surface.closest(v).normal;
    tool.pose.position_m = v + normal * (-0.008 + 0.028 * random.uniform());
    tool.pose.orientation = anyTurn(random);
    tool.grip = random.uniform();
  }
  return tools;
}

/// Signed distance of the deepest of the place of entry and the points 4, 8 and 16 mm behind it.
double deepestWithin_m(const CollisionMesh& surface, const Segment& axis, const SegmentHit& entry) {
  const Vec3 way_m = axis.to_m - axis.from_m;
  const double inwards = dot(way_m, entry.surface.normal) < 0.0 ? 1.0 : -1.0;
  double deepest_m = 0.0;
  for (const double behind_m : {0.004, 0.008, 0.016}) {
    const double along = std::clamp(entry.along + inwards * behind_m / norm(way_m), 0.0, 1.0);
    deepest_m = std::min(deepest_m, surface.closest(axis.at(along)).distance_m);
  }
  return deepest_m;
}

void agreesWithTheMovedMesh(const Scene& scene, const OrganState& organ, int count) {
  const TriangleMesh mesh = moved(scene, organ);
  const CollisionMesh surface(mesh);
  int touching = 0;
  int shafts = 0;
  for (const ToolState& tool : toolsNear(mesh, surface, count)) {
    const ToolShape shape = toolShape(tool, scene.instrument);

    const ToolTouch touch = touchFresh(shape, scene, organ, false);

    const SurfacePoint tip = surface.closest(shape.tip_m);
    if (std::isfinite(touch.tip.gap_m)) {
      ASSERT_NEAR(touch.tip.gap_m, tip.distance_m - shape.tipRadius_m, kTouchRounding_m);
      ASSERT_NEAR(norm(touch.tip.point_m - tip.position_m), 0.0, 1e-6);
    } else {
      ASSERT_GT(tip.distance_m, 0.009);
    }
    const SegmentHit shaft = surface.nearest(shape.shaft, shape.tipRadius_m + kLookAhead_m);
    ASSERT_EQ(shaft.found, std::isfinite(touch.shaft.gap_m));
    if (shaft.found && shaft.surface.distance_m > 0.0) {
      ASSERT_NEAR(touch.shaft.gap_m, shaft.surface.distance_m - shape.tipRadius_m, kTouchRounding_m);
      ASSERT_NEAR(norm(touch.shaft.normal), 1.0, 1e-9);
    }
    if (shaft.found && shaft.surface.distance_m == 0.0) {
      const double deepest_m = deepestWithin_m(surface, shape.shaft, shaft);
      ASSERT_NEAR(touch.shaft.gap_m, deepest_m - shape.tipRadius_m, kTouchRounding_m);
    }
    touching += touch.jaw.gap_m < 0.0 ? 1 : 0;
    shafts += touch.shaft.gap_m < 0.0 ? 1 : 0;
  }
  EXPECT_GT(touching, count / 10);
  EXPECT_GT(shafts, count / 10);
}

// A patch that reaches beyond its assumed bound hides its triangles from a tip that lies on them. Every
// third.
void meetsTheTrianglesThatATipLiesOn(const Scene& scene, const OrganState& organ) {
  const TriangleMesh mesh = moved(scene, organ);
  int missed = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const TriangleMesh::Triangle& t = mesh.triangles[i];
    const Vec3 on_m = (mesh.vertices_m[t[0]] + mesh.vertices_m[t[1]] + mesh.vertices_m[t[2]]) / 3.0;
    missed += std::abs(nearestSurface(on_m, scene, organ).distance_m) > 1e-9 ? 1 : 0;
  }
  EXPECT_EQ(missed, 0);
}

TEST(ToolTouch, AgreesWithEveryTriangleOfATwistedBar) {
  const Scene scene = barScene();
  for (const double angle_rad : {0.0, 0.3, -1.5, 4.0}) {
    SCOPED_TRACE(angle_rad);
    agreesWithTheMovedMesh(scene, {{0.2, angle_rad}, {}}, 300);
    meetsTheTrianglesThatATipLiesOn(scene, {{0.2, angle_rad}, {}});
  }
}

TEST(ToolTouch, AgreesWithEveryTriangleOfTheShippedOrgansTwistedToTheirTargets) {
  const std::filesystem::path assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  for (const std::string& id : sceneIds(assets)) {
    SceneRequest request = testing::shippedRequest(id);
    for (const std::string& pattern : patternIds(assets, id)) {
      SCOPED_TRACE(id + ", " + pattern);
      request.pattern = pattern;
      const Scene scene = loadScene(request);
      agreesWithTheMovedMesh(scene, scene.stateAt(scene.pattern.targetAngle_rad), 120);
      if (scene.hollow) {
        agreesWithTheMovedMesh(scene, scene.hollow->start(1), 120);
      } else {
        meetsTheTrianglesThatATipLiesOn(scene, scene.stateAt(1.5 * scene.pattern.targetAngle_rad));
      }
    }
  }
}

TEST(ToolTouch, AgreesWithFclOnATwistedBar) {
  const Scene scene = barScene();
  const OrganState organ{{0.2, 1.2}, {}};
  const TriangleMesh mesh = moved(scene, organ);
  const CollisionMesh surface(mesh);
  const auto model = testing::fclModel(mesh);

  int compared = 0;
  for (const ToolState& tool : toolsNear(mesh, surface, 400)) {
    const ToolShape shape = toolShape(tool, scene.instrument);
    const ToolTouch touch = touchFresh(shape, scene, organ, false);
    if (!(touch.shaft.gap_m > 0.0) || !std::isfinite(touch.shaft.gap_m)) {
      continue;  // FCL has no depth
    }
    const auto capsule =
        std::make_shared<fcl::Capsuled>(shape.tipRadius_m, norm(shape.shaft.to_m - shape.shaft.from_m));
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    const Quat& q = tool.pose.orientation;
    pose.linear() = fcl::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
    const Vec3 middle = shape.shaft.at(0.5);
    pose.translation() = fcl::Vector3d(middle.x, middle.y, middle.z);
    fcl::DistanceResultd result;
    fcl::distance(model.get(), fcl::Transform3d::Identity(), capsule.get(), pose, fcl::DistanceRequestd(true),
                  result);
    EXPECT_NEAR(touch.shaft.gap_m, result.min_distance, kFcl_m);
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

/// A part as the memory of earlier ticks tells it, against a fresh query.
void sameWhereItMatters(const PartTouch& remembered, const PartTouch& fresh) {
  if (fresh.gap_m <= kLookAhead_m) {
    ASSERT_EQ(remembered.gap_m, fresh.gap_m);
    ASSERT_EQ(remembered.point_m, fresh.point_m);
    ASSERT_EQ(remembered.normal, fresh.normal);
  } else {
    ASSERT_GT(remembered.gap_m, kLookAhead_m);
  }
}

/// Wanders about the organ as it turns there and back, and compares every tick.
void remembersNothingWrong(const Scene& scene, std::uint64_t seed) {
  constexpr int kTicks = 3'000;
  Random random(seed);
  TouchMemory memory;
  int spared = 0;
  int touching = 0;
  ToolState tool;
  Vec3 aim_m;
  OrganState organ;
  for (int i = 0; i < kTicks; ++i) {
    if (i % 250 == 0) {
      aim_m = scene.mesh.vertices_m[random.bounded(scene.mesh.vertices_m.size())];
      aim_m += Vec3{random.normal(), random.normal(), random.normal()} * 0.02;
      tool.pose.orientation = anyTurn(random);
    }
    if (i % 1'000 == 500) {
      organ.twist.graspArc_m = random.uniform() * scene.lattice().length_m();
    }
    tool.pose.position_m += (aim_m - tool.pose.position_m) * 0.01;
    const double phase = static_cast<double>(i % 1'000 - 500) / 500.0;
    organ.twist.graspAngle_rad = phase > 0.0 ? 4.0 * phase * (1.0 - phase) : 0.0;  // rad
    tool.grip = i % 500 < 250 ? 0.0 : 1.0;
    const ToolShape shape = toolShape(tool, scene.instrument);
    const bool holding = i % 1'000 > 600;

    const ToolTouch remembered = touchTool(shape, scene, organ, holding, memory);

    const ToolTouch fresh = touchFresh(shape, scene, organ, holding);
    sameWhereItMatters(remembered.tip, fresh.tip);
    sameWhereItMatters(remembered.jaw, fresh.jaw);
    sameWhereItMatters(remembered.shaft, fresh.shaft);
    spared += std::isfinite(fresh.tip.gap_m) && !std::isfinite(remembered.tip.gap_m) ? 1 : 0;
    touching += fresh.jaw.gap_m <= kLookAhead_m || fresh.shaft.gap_m <= kLookAhead_m ? 1 : 0;
  }
  EXPECT_GT(spared, kTicks / 20);
  EXPECT_GT(touching, kTicks / 20);
}

TEST(ToolTouch, RememberingEarlierTicksChangesNoAnswer) {
  const Scene bar = barScene();
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    SCOPED_TRACE(seed);
    remembersNothingWrong(bar, seed);
  }
  remembersNothingWrong(testing::shippedScene(), 5);
}

TEST(ToolTouch, MeasuresTheDepthOfAShaftThatHasEntered) {
  const Scene scene = barScene();
  ToolState tool;
  tool.pose.orientation = axisAngle({1.0, 0.0, 0.0}, -0.5 * kPi);  // shaft along +y, through the bar
  for (const double depth_m : {0.001, 0.002, 0.004, 0.008}) {
    tool.pose.position_m = {kBarRadius_m + 0.0025 - depth_m, -0.060, 0.125};

    const ToolTouch touch = touchFresh(toolShape(tool, scene.instrument), scene, {}, false);

    // Beyond the shaft's radius the deepest of some points counts: a chord of the circle, 72 sides.
    EXPECT_NEAR(-touch.shaft.gap_m, depth_m, depth_m < 0.0025 ? 4e-5 : 0.15 * depth_m);
    EXPECT_GT(touch.shaft.normal.x, 0.8);
  }
}

TEST(ToolTouch, OpensTheBladesByTheGrip) {
  ToolState tool;
  const ToolShape open = toolShape(tool, Instrument{});
  tool.grip = 1.0;
  const ToolShape closed = toolShape(tool, Instrument{});

  // 20 mm at 25 degrees: 8.45 mm to the side, 1.87 mm back.
  EXPECT_NEAR(std::abs(open.blades[0].to_m.y), 0.00845, 1e-5);
  EXPECT_NEAR(open.blades[0].to_m.z, 0.00187, 1e-5);
  EXPECT_EQ(open.blades[0].to_m.y, -open.blades[1].to_m.y);
  EXPECT_NEAR(norm(closed.blades[0].to_m), 0.0, 1e-15);
  EXPECT_EQ(open.shaft.from_m, (Vec3{0.0, 0.0, kJawLength_m}));
}

/// The jaw is a constant of the tick, because it is no part of a trial's parameter hash (docs/contact.md).
TEST(ToolTouch, UsesTheJawOfTheShippedGrasper) {
  const std::filesystem::path folder = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets" / "instruments";
  const nlohmann::json file = nlohmann::json::parse(readFile(folder / "grasper.json"));
  const TriangleMesh blade = importMesh(folder / file.at("meshes").at("upper_jaw").get<std::string>(),
                                        {.scale_m = 1e-3, .organ = false});

  // The hinge lies behind the tip, on the shaft; the blades turn about the tool's x axis.
  EXPECT_EQ(file.at("jaws").at("pivot_mm"), nlohmann::json({0.0, 0.0, kJawLength_m * 1e3}));
  EXPECT_EQ(file.at("jaws").at("axis"), nlohmann::json({1.0, 0.0, 0.0}));
  EXPECT_DOUBLE_EQ(radians(file.at("jaws").at("opening_deg").get<double>()), kJawOpening_rad);

  // The capsule of a blade is thicker than the drawn blade is flat (2.22 mm) and thinner than it is wide
  // (4.6 mm): 2 * 0.6 * 2.5 mm = 3 mm.
  Vec3 low_m = blade.vertices_m.front();
  Vec3 high_m = low_m;
  for (const Vec3& v : blade.vertices_m) {
    low_m = {std::min(low_m.x, v.x), std::min(low_m.y, v.y), std::min(low_m.z, v.z)};
    high_m = {std::max(high_m.x, v.x), std::max(high_m.y, v.y), std::max(high_m.z, v.z)};
  }
  const double capsule_m = 2.0 * kBladeShare * file.at("tip_radius_mm").get<double>() * 1e-3;
  EXPECT_GT(capsule_m, high_m.y - low_m.y);
  EXPECT_LT(capsule_m, high_m.x - low_m.x);
}

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
