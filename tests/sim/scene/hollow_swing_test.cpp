// SPDX-License-Identifier: GPL-3.0-or-later
// The stomach that comes twisted about the line between its ends: what moves where, and that it is the
// stomach of the training task.
#include "sim/scene/hollow_swing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/pattern_judgement.h"
#include "sim/scene/scene_file.h"
#include "sim/tissue/rod/fold_check.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

using testing::twistedOrgan;

const Scene& comesTwisted() {
  return twistedOrgan("gastric-organo-axial");
}

Vec3 centroid_m(const TriangleMesh& mesh, const std::vector<Vec3>& at_m) {
  double volume = 0.0;
  Vec3 sum;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = at_m[t[0]];
    const Vec3& b = at_m[t[1]];
    const Vec3& c = at_m[t[2]];
    const double sixfold = dot(a, cross(b, c));
    volume += sixfold;
    sum += 0.25 * sixfold * (a + b + c);
  }
  return sum / volume;
}

Vec3 centroidAt_m(const Scene& scene, const OrganState& lies) {
  std::vector<Vec3> at_m(scene.mesh.vertices_m.size());
  scene.deform(lies, at_m);
  return centroid_m(scene.mesh, at_m);
}

// Landmarks of the shipped stomach, as in the training task (assets/scenes/stomach.json).
constexpr Vec3 kPylorus_m{-0.047, 0.004, -0.068};
constexpr Vec3 kCardia_m{0.021, 0.018, 0.042};
constexpr Vec3 kGreaterCurvature_m{0.088, -0.008, -0.052};
constexpr Vec3 kAntrum_m{-0.020, 0.004, -0.090};

TEST(HollowSwing, TheGreaterCurvatureRisesOverTheLineBetweenTheEnds) {
  const Scene& scene = comesTwisted();
  const Vec3 along = normalized(kCardia_m - kPylorus_m);
  const auto across = [&](const Vec3& p) { return (p - kPylorus_m) - dot(p - kPylorus_m, along) * along; };

  const OrganState half = scene.stateAt(radians(-90.0));
  const OrganState whole = scene.stateAt(radians(-180.0));

  // Forward first, then over the line: right of it and above where it was (Medscape 2054271).
  const Vec3 forward = scene.toDeformed_m(kGreaterCurvature_m, half);
  const Vec3 over = scene.toDeformed_m(kGreaterCurvature_m, whole);
  EXPECT_LT(forward.y, kGreaterCurvature_m.y - 0.06);
  EXPECT_GT(over.z, kGreaterCurvature_m.z + 0.09);
  EXPECT_LT(over.x, -0.06);
  const Vec3 before = across(kGreaterCurvature_m);
  const Vec3 after = across(over);
  EXPECT_LT(dot(before, after) / (norm(before) * norm(after)), std::cos(radians(155.0)));
  // The antrum goes up with it.
  EXPECT_GT(scene.toDeformed_m(kAntrum_m, whole).z, kAntrum_m.z + 0.02);
}

TEST(HollowSwing, PylorusAndCardiaStayWhereTheyAreHeld) {
  const Scene& scene = comesTwisted();
  for (const double angle_deg : {-210.0, -180.0, -90.0, 90.0, 180.0, 210.0}) {
    const OrganState lies = scene.stateAt(radians(angle_deg));

    EXPECT_LT(norm(scene.toDeformed_m(kPylorus_m, lies) - kPylorus_m), 0.006) << angle_deg;
    EXPECT_LT(norm(scene.toDeformed_m(kCardia_m, lies) - kCardia_m), 0.012) << angle_deg;
  }
}

TEST(HollowSwing, IsTheStomachOfTheTrainingTask) {
  const Scene task = testing::shippedScene("stomach", "organo-axial");
  const Scene& scene = comesTwisted();
  const Vec3 rest_m = centroid_m(scene.mesh, scene.mesh.vertices_m);

  const double moved_m = norm(centroidAt_m(scene, scene.stateAt(radians(-180.0))) - rest_m);
  const double byTask_m = norm(centroidAt_m(task, task.stateAt(radians(-180.0))) - rest_m);

  EXPECT_GT(moved_m, 0.095);
  EXPECT_NEAR(moved_m, byTask_m, 0.020);
}

TEST(HollowSwing, StaysWholeAtEveryAngleItMayComeWith) {
  const Scene& scene = comesTwisted();
  const FoldCheck check(scene.mesh, scene.lattice());
  const double most_rad = scene.hollow->detorsion().start.most_rad;
  for (const double share : {-1.0, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0}) {
    const FoldReport fold = foldOf(scene, check, scene.stateAt(share * most_rad));

    EXPECT_GT(fold.minDeterminant, 0.5) << share;
    EXPECT_EQ(fold.crossings, 0U) << share;
    EXPECT_NEAR(fold.volumeRatio, 1.0, 0.05) << share;
  }
}

TEST(HollowSwing, TakesMoreTorqueTheFartherItIsTurnedAndGivesItBack) {
  const HollowOrgan& organ = *comesTwisted().hollow;
  const double pressure_Pa = organ.detorsion().wall.pressure_Pa;
  double before_Nm = 0.0;
  for (double angle_deg = 15.0; angle_deg <= 195.0; angle_deg += 15.0) {
    const double torque_Nm = -organ.torque_Nm(radians(-angle_deg), pressure_Pa);

    EXPECT_GT(torque_Nm, before_Nm) << angle_deg;
    before_Nm = torque_Nm;
  }
  EXPECT_EQ(organ.within_rad(10.0), organ.within_rad(20.0));
}

TEST(HollowSwing, FindsItsWayBackFromItsSurface) {
  const Scene& scene = comesTwisted();
  const OrganState lies = scene.stateAt(radians(-180.0));
  const RodSkin& skin = scene.hollow->swing()->rod().skin();
  const RodCurve curve = scene.hollow->curveOf(lies);
  std::size_t astray = 0;
  for (std::size_t i = 0; i < scene.mesh.vertices_m.size(); i += 50) {
    const Vec3& rest_m = scene.mesh.vertices_m[i];
    astray += norm(skin.toRest_m(skin.toDeformed_m(rest_m, curve), curve) - rest_m) < 1e-6 ? 0 : 1;
  }
  EXPECT_LE(astray, scene.mesh.vertices_m.size() / 50 / 20);  // of oesophagus and bulb, beyond the sections
}

/// Where the middle of the section at a share of the length lies.
Vec3 middleAt_m(const Scene& scene, double share, const OrganState& lies) {
  return scene.toDeformed_m(scene.lattice().frameAt(share * scene.lattice().length_m()).centre_m, lies);
}

Vec3 restingAt_m(const Scene& scene, double share) {
  return scene.lattice().frameAt(share * scene.lattice().length_m()).centre_m;
}

double centroidMoves_m(const Scene& scene, const OrganState& lies) {
  return norm(centroidAt_m(scene, lies) - centroid_m(scene.mesh, scene.mesh.vertices_m));
}

// Crossing sigmoid transitions, the sign of the more complete twists (AJR 194 (2010)
// 136, 10.2214/AJR.09.2580).
TEST(HollowMotion, AHalfTurnOfASigmoidCrossesItsLimbsAndChangesItsShoulders) {
  const Scene& scene = twistedOrgan("sigmoid");
  for (const double way : {1.0, -1.0}) {
    const OrganState lies = scene.stateAt(way * radians(180.0));
    EXPECT_LT(norm(middleAt_m(scene, 0.4, lies) - restingAt_m(scene, 0.6)), 0.005);
    EXPECT_LT(norm(middleAt_m(scene, 0.6, lies) - restingAt_m(scene, 0.4)), 0.005);
    const Vec3 first = middleAt_m(scene, 0.2, lies);  // of the limbs
    const Vec3 last = middleAt_m(scene, 0.8, lies);
    EXPECT_LT(first.x * restingAt_m(scene, 0.2).x, 0.0);
    EXPECT_LT(last.x * restingAt_m(scene, 0.8).x, 0.0);
    EXPECT_GT(way * (first.y - last.y), 0.08);  // one in front of the other
    EXPECT_LT(centroidMoves_m(scene, lies), 0.005);
    for (const double foot : {0.0, 1.0}) {
      EXPECT_LT(norm(middleAt_m(scene, foot, lies) - restingAt_m(scene, foot)), 1e-4);
    }
  }
}

TEST(HollowMotion, AHalfTurnOfABowelLoopCrossesItsLimbsAndBringsItsTopForward) {
  const Scene& scene = twistedOrgan("small-bowel-loop");
  for (const double way : {1.0, -1.0}) {
    const OrganState lies = scene.stateAt(way * radians(180.0));
    const Vec3 first = middleAt_m(scene, 0.4, lies);
    EXPECT_NEAR(first.x, restingAt_m(scene, 0.6).x, 0.003);
    EXPECT_NEAR(first.z, restingAt_m(scene, 0.6).z, 0.015);
    EXPECT_NEAR(middleAt_m(scene, 0.5, lies).y - restingAt_m(scene, 0.5).y, -0.079, 0.005);
    EXPECT_NEAR(centroidMoves_m(scene, lies), 0.019, 0.003);
    for (const double foot : {0.0, 1.0}) {
      EXPECT_LT(norm(middleAt_m(scene, foot, lies) - restingAt_m(scene, foot)), 1e-4);
    }
  }
}

// The model has no hinge at the middle of the curvatures (its scene says so): the antrum goes to the left and
// forward, not up.
TEST(HollowMotion, TheAntrumOfAStomachThatIsWrungGoesToTheLeftAndForward) {
  const Scene& scene = twistedOrgan("gastric-mesentero-axial");
  const OrganState lies = scene.stateAt(radians(180.0));
  const Vec3 pylorus_m = middleAt_m(scene, 0.0, lies) - restingAt_m(scene, 0.0);
  EXPECT_NEAR(pylorus_m.x, 0.131, 0.01);
  EXPECT_NEAR(pylorus_m.y, -0.069, 0.01);
  EXPECT_NEAR(pylorus_m.z, -0.073, 0.01);
  EXPECT_NEAR(centroidMoves_m(scene, lies), 0.011, 0.003);
  EXPECT_LT(norm(middleAt_m(scene, 0.95, lies) - restingAt_m(scene, 0.95)), 1e-9);
}

// Markers of the shipped midgut (assets/organs/midgut_markers.json): x to the patient's left, y to the back,
// z up, and the line of the stalk from the root of the mesentery to the front.
constexpr Vec3 kPackLeft_m{0.0467, -0.0181, -0.0175};
constexpr Vec3 kPackAbove_m{0.0, -0.0491, 0.0146};
constexpr Vec3 kPackBelow_m{0.0, 0.0158, -0.0526};
constexpr Vec3 kStalkRoot_m{0.0, 0.05035, 0.04863};
constexpr Vec3 kStalkFront_m{0.0, -0.04316, -0.04168};
constexpr double kStalkRadius_m = 0.008;

/// The place on the other side of the line of the stalk, as far from it.
Vec3 beyondStalk_m(const Vec3& p_m) {
  const Vec3 along = normalized(kStalkFront_m - kStalkRoot_m);
  const Vec3 foot_m = kStalkRoot_m + dot(p_m - kStalkRoot_m, along) * along;
  return foot_m + (foot_m - p_m);
}

/// How far a place has turned about the line of the stalk, right-handed from the root to the front.
double turnAboutStalk_rad(const Vec3& rest_m, const Vec3& now_m) {
  const Vec3 along = normalized(kStalkFront_m - kStalkRoot_m);
  const auto across = [&](const Vec3& p) {
    return (p - kStalkRoot_m) - dot(p - kStalkRoot_m, along) * along;
  };
  return std::atan2(dot(along, cross(across(rest_m), across(now_m))), dot(across(rest_m), across(now_m)));
}

/// The mean of that of the limb that lies beside the stalk, between two heights above the root, m.
double limbTurns_rad(const Scene& scene, const std::vector<Vec3>& now_m, double from_m, double to_m) {
  const Vec3 along = normalized(kStalkFront_m - kStalkRoot_m);
  double sum_rad = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < now_m.size(); ++i) {
    const Vec3& rest_m = scene.mesh.vertices_m[i];
    const double height_m = dot(rest_m - kStalkRoot_m, along);
    const double beside_m = norm(rest_m - kStalkRoot_m - height_m * along);
    if (height_m >= from_m && height_m < to_m && beside_m > kStalkRadius_m + 0.003) {
      sum_rad += turnAboutStalk_rad(rest_m, now_m[i]);
      ++count;
    }
  }
  EXPECT_GT(count, 30);
  return sum_rad / count;
}

// Mesentery and bowel wrap clockwise round the superior mesenteric artery, as seen from the front: the
// whirlpool sign in 12 of 13 patients (Radiology 1996, 10.1148/radiology.199.1.8633156).
TEST(HollowMotion, AMidgutTurnsClockwiseOnItsStalkAndWindsItsLimbRoundIt) {
  const Scene& scene = twistedOrgan("midgut");
  const OrganState quarter = scene.stateAt(radians(-90.0));
  const OrganState half = scene.stateAt(radians(-180.0));
  std::vector<Vec3> now_m(scene.mesh.vertices_m.size());
  scene.deform(half, now_m);

  // From above to the patient's left, which whoever stands in front sees on the right, and on to below.
  EXPECT_LT(norm(scene.toDeformed_m(kPackAbove_m, quarter) - kPackLeft_m), 0.004);
  EXPECT_LT(norm(scene.toDeformed_m(kPackLeft_m, quarter) - kPackBelow_m), 0.004);
  EXPECT_LT(norm(beyondStalk_m(kPackAbove_m) - kPackBelow_m), 0.005);
  EXPECT_LT(norm(scene.toDeformed_m(kPackAbove_m, half) - beyondStalk_m(kPackAbove_m)), 0.001);
  EXPECT_NEAR(centroidMoves_m(scene, half), 0.022, 0.003);
  EXPECT_LT(norm(scene.toDeformed_m(kStalkRoot_m, half) - kStalkRoot_m), 0.001);

  // The end of the limb stays, and the limb goes round the stalk by as much as the pack at its other end.
  EXPECT_GT(limbTurns_rad(scene, now_m, -0.010, 0.0), radians(-5.0));
  EXPECT_NEAR(limbTurns_rad(scene, now_m, 0.024, 0.030), radians(-85.0), radians(10.0));
  EXPECT_LT(limbTurns_rad(scene, now_m, 0.048, 0.054), radians(-145.0));
}

TEST(TwistLaw, OneThatIsProportionalChangesNothing) {
  const Scene scene = testing::shippedScene("stomach", "organo-axial");
  const std::vector<Restraint> restraints =
      readSceneFile(testing::shippedRequest().assets, "stomach").restraints;
  const RodOrgan& plain = *scene.rod;
  const double length_m = scene.lattice().length_m();
  double compliance = 0.0;
  const std::span<const double> arcs_m = plain.arcs_m();
  for (std::size_t i = 0; i + 1 < arcs_m.size(); ++i) {
    const double middle_m = 0.5 * (arcs_m[i] + arcs_m[i + 1]);
    if (middle_m >= 0.1 * length_m && middle_m < 0.4 * length_m) {
      const RodElement& element = plain.rod().elements()[i];
      compliance += element.length_m / element.bend_Nm2[8];
    }
  }
  const auto withLaw = [&](double share) {
    return RodOrgan({.mesh = &scene.mesh,
                     .model = &scene.model,
                     .restraints = restraints,
                     .task = *scene.pattern.task,
                     .graspArc = scene.pattern.graspArc,
                     .laws = {{0.1 * length_m, 0.4 * length_m,
                               [=](double twist_rad) { return share * twist_rad / compliance; }}}});
  };
  const RodOrgan bare({.mesh = &scene.mesh,
                       .model = &scene.model,
                       .restraints = restraints,
                       .task = *scene.pattern.task,
                       .graspArc = scene.pattern.graspArc});

  const TaskPoint free = atAngle(bare.follow(0.5, radians(-30.0)), radians(-30.0));
  const TaskPoint same = atAngle(withLaw(1.0).follow(0.5, radians(-30.0)), radians(-30.0));
  const TaskPoint soft = atAngle(withLaw(0.25).follow(0.5, radians(-30.0)), radians(-30.0));

  EXPECT_NEAR(same.torque_Nm, free.torque_Nm, 1e-6);
  EXPECT_GT(std::abs(soft.twist_rad[0]), std::abs(same.twist_rad[0]));
}

}  // namespace
}  // namespace torsio
