// SPDX-License-Identifier: GPL-3.0-or-later
// What holds the rod: patches, slack, the jaw.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/pose.h"
#include "sim/tissue/rod/landmark_turn.h"
#include "sim/tissue/rod/rod_energy.h"
#include "sim/tissue/rod/rod_solve.h"
#include "tests/sim/tissue/rod/rod_scenes.h"
#include "tests/sim/tissue/rod/rod_shapes.h"

namespace torsio {
namespace {

TEST(NodesAround, AreThoseWithinHalfTheWidth) {
  const std::vector<RodElement> elements(10, RodElement{.length_m = 0.01});

  const NodeRange middle = nodesAround(elements, 0.05, 0.02, 16);
  const NodeRange end = nodesAround(elements, 0.0, 0.02, 16);
  const NodeRange between = nodesAround(elements, 0.054, 0.001, 16);
  const NodeRange few = nodesAround(elements, 0.05, 0.03, 3);

  EXPECT_EQ(middle.first, 3);
  EXPECT_EQ(middle.last, 7);
  EXPECT_EQ(end.first, 0);
  EXPECT_EQ(end.last, 2);
  EXPECT_EQ(between.first, 5);
  EXPECT_EQ(between.last, 5);
  EXPECT_EQ(few.first, 4);
  EXPECT_EQ(few.last, 6);
}

/// A thin rod of ten elements, 100 mm long.
Rod heldRod(const RodPose& rest, const RodRestraints& held) {
  return {std::vector<RodElement>(10, straightElement({0.01, 0.01, 9e3, 3e3}, 0.01)), rest,
          std::vector<double>(11, 0.0), held};
}

TEST(PatchSpring, PullsAtItsPointWithItsWholeStiffness) {
  const RodPose rest = straightPose(0.1, 10);
  RodRestraints held;
  const Vec3 point{0.02, 0, 0.05};
  addPatchSpring({.nodes = {.first = 4, .last = 6},
                  .point_m = point,
                  .anchor_m = point + Vec3{0, 0.03, 0},
                  .slack_m = 0.01,
                  .stiffness_N_per_m = 50},
                 rest, held);
  const Rod rod = heldRod(rest, held);

  const double energy_J = storedEnergy_J(rod, rest, nullptr, {});

  EXPECT_EQ(held.points.size(), 3U);
  EXPECT_NEAR(energy_J, 0.5 * 50 * 0.02 * 0.02, 1e-15);  // stretched by 30 mm, 10 of them slack
}

TEST(PatchSpring, IsSlackUntilItIsStretched) {
  const RodPose rest = straightPose(0.1, 10);
  RodRestraints held;
  addPatchSpring({.nodes = {.first = 5, .last = 5},
                  .point_m = {0, 0, 0.05},
                  .anchor_m = {0, 0.009, 0.05},
                  .slack_m = 0.01,
                  .stiffness_N_per_m = 50},
                 rest, held);
  const Rod rod = heldRod(rest, held);

  const double energy_J = storedEnergy_J(rod, rest, nullptr, {});

  EXPECT_LT(energy_J, 1e-25);  // rounding of the elements
}

TEST(PatchTurn, ResistsATurnOfItsNodes) {
  const RodPose rest = straightPose(0.1, 10);
  RodRestraints held;
  addPatchTurn({.first = 0, .last = 4}, 0.010, rest, held);
  const Rod rod = heldRod(rest, held);
  RodPose turned = rest;

  for (Pose& node : turned.nodes) {
    node = {.position_m = rotateAbout(node.position_m, {1, 0, 0}, 0.01),
            .orientation = axisAngle({1, 0, 0}, 0.01) * node.orientation};
  }

  EXPECT_NEAR(storedEnergy_J(rod, turned, nullptr, {}), 0.5 * 0.010 * 0.01 * 0.01, 1e-11);
}

TEST(RodGrip, PushesBackOnTheHandWithItsStiffness) {
  const Rod rod = stomachRod();
  Pose hand{.position_m = rod.rest().nodes[16].position_m + Vec3{0.03, 0, 0}, .orientation = {}};
  const RodGrip grip = gripAt(rod, rod.rest(), 16, 0.017, hand, {.place_N_per_m = 100, .turn_Nm_per_rad = 1});
  const GripLoad closed = gripLoad(grip, rod.rest(), hand);
  hand.position_m += Vec3{0, 0.002, 0};
  hand.orientation = axisAngle({0, 0, 1}, 0.01);

  const GripLoad moved = gripLoad(grip, rod.rest(), hand);

  EXPECT_EQ(grip.count, 3);  // 8.7 mm apart, 17 mm to each side
  EXPECT_LT(norm(closed.force_N) + norm(closed.torque_Nm), 1e-12);
  EXPECT_LT(norm(moved.force_N - Vec3{0, -0.2, 0}), 1e-12);
  EXPECT_LT(norm(moved.torque_Nm - Vec3{0, 0, -0.01}), 1e-6);
}

TEST(RodGrip, IsTheDerivativeOfTheStoredEnergyByTheHand) {
  const Rod rod = stomachRod();
  Pose hand = rod.rest().nodes[16];
  const RodGrip grip = gripAt(rod, rod.rest(), 16, 0.020, hand, {});
  hand.position_m += Vec3{0.01, -0.02, 0.005};
  hand.orientation = axisAngle(normalized(Vec3{1, 2, 3}), 0.7) * hand.orientation;
  const GripLoad load = gripLoad(grip, rod.rest(), hand);
  constexpr double kBy = 1e-5;
  const auto energy = [&](const Vec3& place, const Vec3& turn) {
    Pose moved = hand;
    moved.position_m += place;
    moved.orientation = axisAngle(normalized(turn), norm(turn)) * moved.orientation;
    return storedEnergy_J(rod, rod.rest(), &grip, moved);
  };

  for (const Vec3& e : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    const double push_N = -(energy(kBy * e, {}) - energy(-kBy * e, {})) / (2.0 * kBy);
    const double twist_Nm = -(energy({}, kBy * e) - energy({}, -kBy * e)) / (2.0 * kBy);
    EXPECT_NEAR(dot(load.force_N, e), push_N, 1e-7);
    EXPECT_NEAR(dot(load.torque_Nm, e), twist_Nm, 1e-7);
  }
}

const Landmarks kRest{.from = {0.01, 0, 0}, .point = {0.05, 0.03, 0.04}, .to = {0.02, 0.01, 0.10}};

Landmarks turned(double angle_rad) {
  const Vec3 axis = normalized(kRest.to - kRest.from);
  Landmarks now = kRest;
  now.point = kRest.from + rotateAbout(kRest.point - kRest.from, axis, angle_rad);
  return now;
}

TEST(LandmarkTurn, IsTheAngleAboutTheLine) {
  for (const double angle : {-2.5, -0.3, 0.0, 1.0, 3.0}) {
    EXPECT_NEAR(landmarkTurn_rad(kRest, turned(angle), 0.0), angle, 1e-12);
  }
}

TEST(LandmarkTurn, CountsWholeTurnsFromTickToTick) {
  double angle_rad = 0.0;

  for (int tick = 1; tick <= 1000; ++tick) {
    angle_rad = landmarkTurn_rad(kRest, turned(-0.01 * tick), angle_rad);
  }

  EXPECT_NEAR(angle_rad, -10.0, 1e-11);
}

TEST(LandmarkTurn, DoesNotSeeAMotionOfTheWholeWithoutTwist) {
  const Vec3 line = normalized(kRest.to - kRest.from);
  const Vec3 across = anyPerpendicular(line);  // tilting the line turns nothing about it
  const auto moved = [&](const Vec3& p) { return Vec3{0.1, -0.2, 0.3} + rotateAbout(p, across, 1.2); };
  const Landmarks now{.from = moved(kRest.from), .point = moved(kRest.point), .to = moved(kRest.to)};

  const double angle_rad = landmarkTurn_rad(kRest, now, 0.0);

  EXPECT_NEAR(angle_rad, 0.0, 1e-12);
}

TEST(LandmarkTurn, KeepsTheLastMeasurementWhereThereIsNone) {
  Landmarks onLine = kRest;
  onLine.point = kRest.from;
  const Landmarks reversed{.from = kRest.to, .point = kRest.point, .to = kRest.from};

  EXPECT_EQ(landmarkTurn_rad(kRest, onLine, 0.7), 0.7);
  EXPECT_EQ(landmarkTurn_rad(kRest, reversed, 0.7), 0.7);
}

}  // namespace
}  // namespace torsio
