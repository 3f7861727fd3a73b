// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped organs as rods: what a surgeon's hand does to them at the clinical targets.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/pose.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/scene.h"
#include "sim/tissue/rod/fold_check.h"
#include "sim/tissue/rod/rod_sections.h"
#include "sim/tissue/rod/rod_skin.h"
#include "sim/tissue/rod/rod_solve.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

Scene shippedScene(const std::string& id) {
  return testing::shippedScene(id);
}

/// One turn of a jaw: where it grips (fraction of the length), about which line, how far. No direction: about
/// the organ's own tangent there, with the place left free.
struct HandTurn {
  double grip = 0.5;
  double angle_deg = 0.0;
  Vec3 from_m{};
  Vec3 direction{};

  [[nodiscard]] bool own() const { return norm(direction) == 0.0; }
};

/// What a hand did to an organ.
struct HandResult {
  RodBalance balance;
  FoldReport fold;
  RodCurve curve;
};

/// A shipped organ as a rod, with what holds it.
class HeldOrgan {
 public:
  explicit HeldOrgan(const std::string& id)
      : scene(shippedScene(id)),
        sections(SolvedSections::solve(scene.lattice(), {})),
        organ(rodOfOrgan(scene.lattice(), sections, {scene.model.material().shearModulus_Pa, 0.5})),
        skin(organ, scene.lattice(), sections, scene.mesh),
        check(scene.mesh, scene.lattice()) {}

  [[nodiscard]] HandResult turned(const std::vector<HandTurn>& turns) const {
    const Rod rod(organ.elements, organ.rest, organ.radii_m, restraints);
    RodPose pose = organ.rest;
    HandResult result;
    for (const HandTurn& turn : turns) {
      const int node = nodeAt(turn.grip);
      const Pose start = pose.nodes[static_cast<std::size_t>(node)];
      const Vec3 axis = turn.own() ? rotate(start.orientation, {0, 0, 1}) : normalized(turn.direction);
      const RodGrip grip = gripAt(rod, pose, node, 0.5 * organ.radii_m[static_cast<std::size_t>(node)], start,
                                  {.place_N_per_m = turn.own() ? 0.0 : 100.0});
      const int steps = static_cast<int>(std::lround(std::abs(turn.angle_deg) / 6.0));
      for (int k = 1; k <= steps; ++k) {
        const double angle = radians(turn.angle_deg) * k / steps;
        Pose hand{start.position_m, axisAngle(axis, angle) * start.orientation};
        if (!turn.own()) {
          hand.position_m = turn.from_m + rotateAbout(start.position_m - turn.from_m, axis, angle);
        }
        result.balance = balanceRod(rod, &grip, hand, {}, pose);
      }
    }
    result.curve = skin.curveOf(pose);
    std::vector<Vec3> vertices(scene.mesh.vertices_m.size());
    skin.deform(result.curve, vertices);
    result.fold =
        check.judge(vertices, [&](const Vec3& rest_m) { return skin.toDeformed_m(rest_m, result.curve); });
    return result;
  }

  [[nodiscard]] double arcOf_m(const Vec3& point_m) const { return skin.placeOf(point_m).arc_m; }

  Scene scene;
  SolvedSections sections;
  OrganRod organ;
  RodSkin skin;
  FoldCheck check;
  RodRestraints restraints;

 private:
  [[nodiscard]] int nodeAt(double share) const {
    const double arc = share * scene.lattice().length_m();
    const auto nearer = [arc](double a, double b) { return std::abs(a - arc) < std::abs(b - arc); };
    return static_cast<int>(std::min_element(organ.arcs_m.begin(), organ.arcs_m.end(), nearer) -
                            organ.arcs_m.begin());
  }
};

const Vec3 kPylorus_m{-0.047, 0.004, -0.068};
const Vec3 kCardia_m{0.021, 0.018, 0.042};
const Vec3 kLesserCurvature_m{0.012, -0.010, -0.040};
const Vec3 kGreaterCurvature_m{0.088, -0.008, -0.052};

/// The stomach between its pylorus (2 N/mm, 10 mN m/rad of a mobile duodenum) and its cardia (1 N/mm over
/// 22 mm). The stiffnesses are assumed.
HeldOrgan heldStomach() {
  HeldOrgan stomach("stomach");
  const RodPose& rest = stomach.organ.rest;
  stomach.restraints.points.push_back(
      {.node = 0, .anchor_m = rest.nodes.front().position_m, .stiffness_N_per_m = 2000.0});
  addPatchTurn({0, 0}, 0.010, rest, stomach.restraints);
  addPatchSpring({.nodes = nodesAround(stomach.organ.elements, stomach.arcOf_m(kCardia_m), 0.011, 5),
                  .point_m = kCardia_m,
                  .anchor_m = kCardia_m,
                  .stiffness_N_per_m = 1000.0},
                 rest, stomach.restraints);
  return stomach;
}

void expectWhole(const HandResult& result, const std::string& what) {
  SCOPED_TRACE(what);
  EXPECT_TRUE(result.balance.converged);
  EXPECT_NEAR(result.fold.volumeRatio, 1.0, 0.005);
  EXPECT_GE(result.fold.minDeterminant, 0.2);
  EXPECT_LE(result.fold.maxDeterminant, 1.05);
  EXPECT_EQ(result.fold.crossings, 0U);
  EXPECT_FALSE(result.fold.folded());
}

TEST(SceneRod, EveryShippedOrganIsGivenBackAtRestToABillionthOfAMillimetre) {
  for (const std::string id : {"stomach", "forearm", "intestine"}) {
    const HeldOrgan organ(id);
    std::vector<Vec3> vertices(organ.scene.mesh.vertices_m.size());

    organ.skin.deform(organ.skin.curveOf(organ.organ.rest), vertices);

    for (std::size_t v = 0; v < vertices.size(); ++v) {
      ASSERT_LT(norm(vertices[v] - organ.scene.mesh.vertices_m[v]), 1e-12) << id << " vertex " << v;
    }
  }
}

TEST(SceneRod, TheStomachStaysWholeUnderEveryTurnWithinItsTorqueLimit) {
  const HeldOrgan stomach = heldStomach();
  const Vec3 longAxis = kCardia_m - kPylorus_m;
  const Vec3 shortAxis = kGreaterCurvature_m - kLesserCurvature_m;
  const HandTurn organoAxial{.grip = 0.5, .angle_deg = -180.0, .from_m = kPylorus_m, .direction = longAxis};
  const auto across = [&](double angle_deg) {
    return HandTurn{
        .grip = 0.25, .angle_deg = angle_deg, .from_m = kLesserCurvature_m, .direction = shortAxis};
  };
  const std::vector<std::pair<std::string, std::vector<HandTurn>>> tasks{
      {"own axis 90", {{.grip = 0.5, .angle_deg = 90.0}}},
      {"own axis 180", {{.grip = 0.5, .angle_deg = 180.0}}},
      {"own axis at 0.7, 90", {{.grip = 0.7, .angle_deg = 90.0}}},
      {"organo-axial -180", {organoAxial}},
      {"mesentero-axial -120", {across(-120.0)}},
      {"mesentero-axial 120", {across(120.0)}},
      {"combined -180, -45", {organoAxial, across(-45.0)}}};
  int task = 0;
  for (const auto& [name, turns] : tasks) {
    const HandResult result = stomach.turned(turns);

    expectWhole(result, name);
    const double cardia = norm(stomach.skin.toDeformed_m(kCardia_m, result.curve) - kCardia_m);
    // The table of docs/model.md R.9, as --gtest_output=xml writes it.
    RecordProperty("task" + std::to_string(++task),
                   name + ": volume " + std::to_string(result.fold.volumeRatio) + ", det F " +
                       std::to_string(result.fold.minDeterminant) + ", torque " +
                       std::to_string(norm(result.balance.load.torque_Nm)) + " N m, cardia " +
                       std::to_string(1000.0 * cardia) + " mm");
    EXPECT_LE(cardia, 0.005) << name;
    EXPECT_LE(norm(result.balance.load.torque_Nm), 0.2) << name;
  }
}

// What a hand that keeps to no limit does to it: the last rows of the stomach in docs/model.md R.9.
TEST(SceneRod, TheStomachIsPressedButNotFoldedByTurnsBeyondItsLimits) {
  const HeldOrgan stomach = heldStomach();
  const HandTurn organoAxial{
      .grip = 0.5, .angle_deg = -180.0, .from_m = kPylorus_m, .direction = kCardia_m - kPylorus_m};
  const HandTurn across{.grip = 0.25,
                        .angle_deg = -90.0,
                        .from_m = kLesserCurvature_m,
                        .direction = kGreaterCurvature_m - kLesserCurvature_m};
  const std::vector<std::vector<HandTurn>> tasks{{{.grip = 0.7, .angle_deg = 180.0}}, {organoAxial, across}};
  int task = 0;
  for (const std::vector<HandTurn>& turns : tasks) {
    const HandResult result = stomach.turned(turns);
    const double cardia = norm(stomach.skin.toDeformed_m(kCardia_m, result.curve) - kCardia_m);
    RecordProperty("task" + std::to_string(++task),
                   "volume " + std::to_string(result.fold.volumeRatio) + ", det F " +
                       std::to_string(result.fold.minDeterminant) + ", crossings " +
                       std::to_string(result.fold.crossings) + ", torque " +
                       std::to_string(norm(result.balance.load.torque_Nm)) + " N m, cardia " +
                       std::to_string(1000.0 * cardia) + " mm");
    EXPECT_FALSE(result.fold.folded());
    EXPECT_EQ(result.fold.crossings, 0U);
    EXPECT_GT(result.fold.minDeterminant, 0.4);
    EXPECT_LT(result.fold.minDeterminant, 0.6) << "tissue inside a bend is pressed to half of its length";
  }
}

TEST(SceneRod, AnOrganoAxialTurnIsASwingThatCostsLittleTorque) {
  const HeldOrgan stomach = heldStomach();
  const HandResult result = stomach.turned(
      {{.grip = 0.5, .angle_deg = -180.0, .from_m = kPylorus_m, .direction = kCardia_m - kPylorus_m}});
  // Measured 22 mN m; a prescribed twist of the same angle asked for 74 mN m and lost 13 % of the volume.
  EXPECT_LT(norm(result.balance.load.torque_Nm), 0.03);
  EXPECT_GT(result.fold.minDeterminant, 0.95);
}

TEST(SceneRod, ALoopOfBowelHeldAtBothFeetStaysWholeOverAWholeTurn) {
  HeldOrgan bowel("intestine");
  const RodPose& rest = bowel.organ.rest;
  for (const int foot : {0, rest.count - 1}) {
    bowel.restraints.points.push_back({.node = foot,
                                       .anchor_m = rest.nodes[static_cast<std::size_t>(foot)].position_m,
                                       .stiffness_N_per_m = 2000.0});
    addPatchTurn({foot, foot}, 0.020, rest, bowel.restraints);
  }
  for (const double angle_deg : {90.0, 180.0, 360.0}) {
    expectWhole(bowel.turned({{.grip = 0.5, .angle_deg = angle_deg}}), std::to_string(angle_deg));
  }
}

TEST(SceneRod, TheForearmTwistsByTheIntegralOfItsCompliance) {
  const HeldOrgan arm("forearm");
  const Rod rod(arm.organ.elements, arm.organ.rest, arm.organ.radii_m);
  const TwistModel integral(arm.scene.mesh, arm.scene.lattice(), arm.scene.model.material(), {});

  const TurnedRod turned = solveTurned(rod, {.angle_rad = radians(1.0), .holdsPlace = false});

  // The rod is 1 mm shorter, where the elbow rounds off, and the axis wanders by a millimetre at the wrist.
  const double compliance = integral.graspCompliance(arm.scene.lattice().length_m());
  EXPECT_NEAR(turned.torque_Nm * compliance / radians(1.0), 1.0, 0.005);
}

TEST(SceneRod, TheForearmStaysWholeAtItsTarget) {
  HeldOrgan arm("forearm");
  arm.restraints.held.push_back({.node = 0});
  expectWhole(arm.turned({{.grip = 1.0, .angle_deg = -60.0}}), "-60 degrees");
}

SceneRequest withSections(const std::string& id, int sections) {
  SceneRequest request = testing::shippedRequest(id);
  request.sections = sections;
  return request;
}

/// One elastic twist about the centreline of the organ that the request names, held at the fixed end.
TwistModel plainTwist(const SceneRequest& request, int solvedSections) {
  const Scene scene = loadScene(request);
  TwistModelOptions options{.solvedSections = solvedSections};
  return {scene.mesh, scene.lattice(), scene.model.material(), options};
}

/// Largest difference in the compliance of a grasp at a quarter, half, 0.85 and the end of the organ, as a
/// share. The torque of an angle is the angle over the compliance.
double largestDifference(const TwistModel& model, const TwistModel& reference) {
  double most = 0.0;
  for (const double place : {0.25, 0.5, 0.85, 1.0}) {
    const double here = model.graspCompliance(place * model.lattice().length_m());
    const double there = reference.graspCompliance(place * reference.lattice().length_m());
    most = std::max(most, std::abs(here / there - 1.0));
  }
  return most;
}

TEST(SceneSections, TheTorqueOfAShippedOrganDoesNotDependOnTheSectionsOfItsLattice) {
  for (const std::string id : {"stomach", "forearm", "intestine"}) {
    const TwistModel reference = plainTwist(withSections(id, 25), 360);
    for (const int sections : {4, 8, 37, 73}) {
      const TwistModel model = plainTwist(withSections(id, sections), TwistModelOptions{}.solvedSections);

      // Before, the sections of the lattice were the ones solved: 21 times the torque of the stomach at M
      // = 4.
      EXPECT_LT(largestDifference(model, reference), 0.005) << id << " " << sections;
    }
  }
}

TEST(SceneSections, TheTorqueOfATaperFollowsTheClosedFormAtEveryNumberOfSections) {
  const double r0 = 0.03;
  const double r1 = 0.015;
  const double length = 0.24;
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "sections_taper.obj";
  writeObj(file, testing::prism(testing::circleOutline(r0, 96), length, 48, r1 / r0));
  for (const int sections : {4, 8, 37, 73}) {
    SceneRequest request = withSections("forearm", sections);
    request.organFile = file;

    const TwistModel model = plainTwist(request, TwistModelOptions{}.solvedSections);

    // phi = 2 T L (r0^2 + r0 r1 + r1^2) / (3 pi G r0^3 r1^3), J of the 96-gon 0.99856 of the circle's.
    const double round = 2.0 * length * (r0 * r0 + r0 * r1 + r1 * r1) /
                         (3.0 * 3.14159265358979 * model.material().shearModulus_Pa * std::pow(r0 * r1, 3.0));
    EXPECT_NEAR(model.graspCompliance(length) * 0.99856 / round, 1.0, 1e-4) << sections;
  }
}

}  // namespace
}  // namespace torsio
