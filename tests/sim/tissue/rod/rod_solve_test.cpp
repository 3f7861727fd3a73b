// SPDX-License-Identifier: GPL-3.0-or-later
// What a hyperelastic rod at rest cannot help doing: reciprocity, no memory of the path, the way back.
#include "sim/tissue/rod/rod_solve.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/tissue/rod/rod_system.h"
#include "tests/sim/tissue/rod/rod_scenes.h"
#include "tests/sim/tissue/rod/rod_shapes.h"

namespace torsio {
namespace {

constexpr int kSolvedElements = 31;

Rod bentTube(double angle_rad) {
  const RodPose pose = bentPose(0.24, angle_rad, kSolvedElements);
  std::vector<RodElement> elements(
      kSolvedElements, curvedElement({0.020, 0.020, 2.9e4, 1e4}, angle_rad / 0.24, 0.24 / kSolvedElements));
  restAt(pose, elements);
  return Rod(elements, pose, std::vector<double>(kSolvedElements + 1, 0.0));
}

const std::vector<HeldNode> kBothEnds{{.node = 0}, {.node = kSolvedElements}};

TEST(RodSolve, IsReciprocal) {
  // Maxwell and Betti: with the ends held, the force at b for a small move at a is that at a for the same
  // move at b.
  const Rod rod = bentTube(kPi / 2);
  constexpr double kMove_m = 1e-9;
  const auto force = [&](int moved, Vec3 by, int read, Vec3 along) {
    const std::vector<HeldNode> held{{.node = 0}, {.node = 10}, {.node = 22}, {.node = kSolvedElements}};
    RodPose pose = rod.rest();
    pose.nodes[static_cast<std::size_t>(moved)].position_m += kMove_m * by;
    const RodBalance balance = balanceRod(rod, nullptr, {}, held, pose);
    return dot(balance.held[read == 10 ? 1U : 2U].force_N, along) / kMove_m;
  };
  const Vec3 u = normalized(Vec3{1, 2, 3});
  const Vec3 v = normalized(Vec3{-2, 1, 1});

  const double there = force(10, u, 22, v);
  const double back = force(22, v, 10, u);

  EXPECT_GT(std::abs(there), 1e-3);
  EXPECT_NEAR(there, back, 1e-6 * std::abs(there));  // differences of 1e-9 m: nine digits of sixteen are left
}

TEST(RodSolve, GivesWayAlikeThereAndBack) {
  // The same to rounding: of a pose at rest, bent and twisted far, the way of b under a small force on a is
  // that of a under the same force on b.
  const Rod rod = bentTube(kPi / 2);
  const TurnedRod turned = solveTurned(rod, {.angle_rad = radians(60.0)});
  const auto system = std::make_unique<RodSystem>();
  assemble({.rod = &rod, .near = rod.contactPairs(), .held = kBothEnds}, turned.pose, 0.0, *system);
  ASSERT_EQ(factorise(*system), 0);
  const auto way = [&](std::size_t pushed, std::size_t along, std::size_t read, std::size_t seen) {
    NodeVector force{};
    NodeVector moved{};
    force[pushed][along] = 1.0;
    solveFactorised(*system, force, moved);
    return moved[read][seen];
  };

  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < 6; ++b) {
      const double there = way(7, a, 22, b);
      const double back = way(22, b, 7, a);
      const double scale = std::sqrt(way(7, a, 7, a) * way(22, b, 22, b));
      EXPECT_NEAR(there, back, 1e-12 * scale) << a << " " << b;
      EXPECT_GT(scale, 0.0);
    }
  }
}

TEST(RodSolve, DoesNotRememberThePath) {
  const Rod rod = bentTube(kPi / 2);
  const Quat rest = rod.rest().nodes[kSolvedElements].orientation;
  const Vec3 tangent = rotate(rest, {0, 0, 1});
  struct Stop {
    double twist_rad, swing_rad;
  };
  const auto along = [&](const std::vector<Stop>& path) {
    RodPose pose = rod.rest();
    RodBalance balance;
    for (const Stop& stop : path) {
      pose.nodes[kSolvedElements].orientation =
          axisAngle({0, 1, 0}, radians(stop.swing_rad)) * axisAngle(tangent, radians(stop.twist_rad)) * rest;
      balance = balanceRod(rod, nullptr, {}, kBothEnds, pose);
    }
    return std::pair{balance, pose};
  };

  const auto [direct, directPose] = along({{30, 0}, {60, 0}, {90, 0}});
  const auto [over, overPose] = along({{60, 0}, {120, 0}, {90, 0}});
  const auto [round, roundPose] = along({{0, 40}, {45, 40}, {90, 40}, {90, 0}});

  for (const auto& [balance, pose] : {std::pair{over, overPose}, std::pair{round, roundPose}}) {
    EXPECT_NEAR(balance.energy_J, direct.energy_J, 1e-12 * direct.energy_J);
    EXPECT_NEAR(norm(balance.held[1].torque_Nm - direct.held[1].torque_Nm), 0.0,
                1e-9 * norm(direct.held[1].torque_Nm));
    for (std::size_t i = 0; i <= kSolvedElements; ++i) {
      EXPECT_LT(norm(pose.nodes[i].position_m - directPose.nodes[i].position_m), 1e-12);
    }
  }
}

TEST(RodSolve, ComesBackFromAWholeTurn) {
  const Rod rod = bentTube(kPi);
  const Quat rest = rod.rest().nodes[kSolvedElements].orientation;
  const Vec3 tangent = rotate(rest, {0, 0, 1});
  RodPose pose = rod.rest();
  const auto turnTo = [&](double angle_rad) {
    pose.nodes[kSolvedElements].orientation = axisAngle(tangent, angle_rad) * rest;
    const RodBalance balance = balanceRod(rod, nullptr, {}, kBothEnds, pose);
    EXPECT_TRUE(balance.converged);
    return balance.energy_J;
  };
  std::vector<double> up_J;
  std::vector<double> down_J;

  for (int step = 0; step <= 18; ++step) {
    up_J.push_back(turnTo(radians(20.0 * step)));
  }
  for (int step = 17; step >= 0; --step) {
    down_J.push_back(turnTo(radians(20.0 * step)));
  }

  EXPECT_GT(up_J[18], 0.1);  // a whole turn is not nothing: the pose counts it
  EXPECT_NEAR(down_J[8], up_J[9], 1e-12 * up_J[9]);
  EXPECT_LT(down_J.back(), 1e-20);
  for (std::size_t i = 0; i <= kSolvedElements; ++i) {
    EXPECT_LT(norm(pose.nodes[i].position_m - rod.rest().nodes[i].position_m), 1e-12);
  }
}

TEST(RodSolve, CountsWholeTurnsOfTheEnd) {
  const Rod rod = bentTube(kPi / 2);

  const TurnedRod turned = solveTurned(rod, {.angle_rad = radians(-400.0)});

  EXPECT_TRUE(turned.balance.converged);
  EXPECT_NEAR(turned.turn_rad.back(), radians(-400.0), 1e-9);
  EXPECT_LT(turned.torque_Nm, 0.0);
}

TEST(RodSolve, TurnsASectionInTheMiddleWhoseFarPartFollows) {
  const Rod rod = bentTube(kPi / 2);

  const TurnedRod turned = solveTurned(rod, {.angle_rad = radians(60.0), .node = 20, .holdsPlace = false});

  ASSERT_TRUE(turned.balance.converged);
  EXPECT_NEAR(turned.turn_rad[20], radians(60.0), 1e-9);
  EXPECT_GT(turned.torque_Nm, 0.0);
  for (std::size_t i = 20; i < kSolvedElements; ++i) {  // nothing holds the far part: it is moved as it is
    const RodStrain strain =
        rodStrain(0.24 / kSolvedElements, turned.pose.nodes[i], turned.pose.nodes[i + 1]);
    const RodElement& e = rod.elements()[i];
    EXPECT_NEAR(strain.curvature_per_m.y, e.restCurvature_per_m[1], 1e-6);
    EXPECT_NEAR(strain.curvature_per_m.z, e.restCurvature_per_m[2], 1e-6);
  }
}

TEST(RodSolve, FindsTheRestOfAnOrganAtRest) {
  const Rod rod = stomachRod();
  RodPose pose = rod.rest();

  const RodBalance balance = balanceRod(rod, nullptr, {}, {}, pose);

  EXPECT_TRUE(balance.converged);
  EXPECT_EQ(balance.negativePivots, 0);
  EXPECT_LT(balance.energy_J, 1e-20);
  EXPECT_EQ(pose.count, 32);
}

}  // namespace
}  // namespace torsio
