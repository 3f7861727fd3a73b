// SPDX-License-Identifier: GPL-3.0-or-later
// What a hyperelastic rod at rest cannot help doing: reciprocity, no memory of the path, the way back.

#include "sim/tissue/rod/rod_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/pose.h"
#include "sim/tissue/rod/landmark_turn.h"
#include "sim/tissue/rod/rod_bench.h"
#include "sim/tissue/rod/rod_energy.h"
#include "sim/tissue/rod/rod_system.h"
#include "tests/sim/tissue/rod/rod_scenes.h"
#include "tests/support/allocation_count.h"

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

namespace {

// What holds the rod: patches, slack, the jaw.

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

namespace {

struct Passivity {
  double worst_J = -1e300;  ///< largest gain of stored energy over the work of the hand, in a tick
  double stored_J = 0.0;    ///< largest stored energy
  int kept = 0;             ///< ticks that took no step
  int contacts = 0;         ///< ticks with contact
};

/// Steps a scene and compares stored energy with the hand's work on the coupling, the rod standing still.
Passivity passivityOf(const RodScene& scene) {
  RunningRodScene run(scene);
  Passivity result;
  double before_J = storedEnergy_J(*scene.rod, run.pose(), &run.grip(), run.hand());
  for (int tick = 0; tick < scene.ticks; ++tick) {
    run.moveHand();
    const double moved_J = storedEnergy_J(*scene.rod, run.pose(), &run.grip(), run.hand());
    const RodStepResult step = run.step();
    const double after_J = storedEnergy_J(*scene.rod, run.pose(), &run.grip(), run.hand());
    result.worst_J = std::max(result.worst_J, (after_J - before_J) - (moved_J - before_J));
    result.stored_J = std::max(result.stored_J, after_J);
    result.kept += step.status == RodStepStatus::kKept ? 1 : 0;
    result.contacts += contactEnergy_J(*scene.rod, scene.rod->contactPairs(), run.pose()) > 0.0 ? 1 : 0;
    before_J = after_J;
  }
  return result;
}

TEST(RodTick, IsPassiveUnderAnyHandConvergedOrNot) {
  const std::vector<RodScene> scenes = rodScenes();
  const RodScene stomach = randomHand(scenes[0], 70'000, 0.005, radians(20.0), 11);
  const RodScene bowel = randomHand(scenes[5], 30'000, 0.060, radians(60.0), 12);

  const Passivity free = passivityOf(stomach);
  const Passivity touching = passivityOf(bowel);

  EXPECT_LE(free.worst_J, 1e-12);
  EXPECT_LE(touching.worst_J, 1e-12);
  EXPECT_GT(free.stored_J, 1e-3);
  EXPECT_GT(touching.stored_J, 1e-2);
  EXPECT_LT(free.kept, 100);
}

TEST(RodTick, IsPassiveInEveryScene) {
  for (const RodScene& scene : rodScenes()) {
    const Passivity result = passivityOf(scene);

    EXPECT_LE(result.worst_J, 1e-12) << scene.name;
    EXPECT_EQ(result.kept, 0) << scene.name;
  }
}

TEST(RodTick, ReachesThePoseAtRestOfAHandThatStops) {
  const RodScene scene = rodScenes()[0];
  RunningRodScene run(scene);
  for (int tick = 0; tick < scene.ticks; ++tick) {
    run.moveHand();
    run.step();
  }
  RodPose rest = run.pose();

  const RodBalance balance = balanceRod(*scene.rod, &run.grip(), run.hand(), {}, rest);

  EXPECT_TRUE(balance.converged);
  for (std::size_t i = 0; i < 32; ++i) {
    EXPECT_LT(norm(run.pose().nodes[i].position_m - rest.nodes[i].position_m), 3e-4);
  }
  EXPECT_LT(norm(gripLoad(run.grip(), run.pose(), run.hand()).force_N - balance.load.force_N), 0.02);
}

TEST(RodTick, TakesTwoStepsAtMostForAJump) {
  const RodScene scene = rodScenes()[3];
  RunningRodScene run(scene);
  double first_Nm = 0.0;
  double last_Nm = 0.0;

  for (int tick = 0; tick < scene.ticks; ++tick) {
    run.moveHand();
    const RodStepResult step = run.step();
    EXPECT_LE(step.newtonSteps, 2);
    EXPECT_TRUE(isFinite(step.load.torque_Nm));
    last_Nm = norm(step.load.torque_Nm);
    first_Nm = tick == 100 ? last_Nm : first_Nm;
  }

  EXPECT_LT(first_Nm, 1.0 * radians(10.0));  // no more than the coupling's own stiffness times the jump
  EXPECT_GT(first_Nm, last_Nm);
  EXPECT_GT(last_Nm, 0.005);
}

TEST(RodTick, StaysWholeWhenTheHandJumpsByFiftyMillimetres) {
  RodScene scene = rodScenes()[3];
  scene.hand = [](int tick, const Pose& rest) {
    Pose pose = rest;
    pose.position_m += tick % 400 >= 200 ? Vec3{0.03, 0.04, 0} : Vec3{};
    return pose;
  };
  RunningRodScene run(scene);
  double highest_N = 0.0;

  for (int tick = 0; tick < 1200; ++tick) {
    run.moveHand();
    const RodStepResult step = run.step();
    ASSERT_LE(step.newtonSteps, 2);
    ASSERT_NE(step.status, RodStepStatus::kKept);
    highest_N = std::max(highest_N, norm(step.load.force_N));
  }

  EXPECT_LE(highest_N, 100.0 * 0.05);
  EXPECT_GT(highest_N, 1.0);
  for (std::size_t i = 0; i < 31; ++i) {
    const RodStrain strain =
        rodStrain(scene.rod->elements()[i].length_m, run.pose().nodes[i], run.pose().nodes[i + 1]);
    EXPECT_NEAR(strain.stretch.z, 1.0, 0.3);
  }
}

TEST(RodTick, KeepsThePoseAndLetsGoOfAHandThatIsNotANumber) {
  const RodScene scene = rodScenes()[0];
  RunningRodScene run(scene);
  for (int tick = 0; tick < 500; ++tick) {
    run.moveHand();
    run.step();
  }
  const RodPose before = run.pose();
  RodPose pose = before;
  const auto work = std::make_unique<RodWorkspace>();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Quat unit;

  for (const Pose& hand :
       {Pose{{kNan, 0, 0}, unit}, Pose{{0, kInfinity, 0}, unit}, Pose{{0, 0, 0}, {kNan, 0, 0, 0}},
        Pose{{0, 0, 0}, {0, 0, 0, 0}}, Pose{{0, 0, 0}, {kInfinity, 0, 0, 0}}}) {
    const RodStepResult step = stepRod(*scene.rod, &run.grip(), hand, 1e-3, pose, *work);

    EXPECT_EQ(step.status, RodStepStatus::kHandLost);
    EXPECT_EQ(step.load, GripLoad{});
    EXPECT_EQ(pose, before);
  }
}

TEST(RodTick, LetsTheOrganBackWhenTheJawOpens) {
  const RodScene scene = rodScenes()[0];
  RunningRodScene run(scene);
  for (int tick = 0; tick < 1500; ++tick) {
    run.moveHand();
    run.step();
  }
  RodPose pose = run.pose();
  const auto work = std::make_unique<RodWorkspace>();
  const double before_J = storedEnergy_J(*scene.rod, pose, nullptr, {});

  for (int tick = 0; tick < 5000; ++tick) {
    const RodStepResult step = stepRod(*scene.rod, nullptr, {}, 1e-3, pose, *work);
    ASSERT_EQ(step.load, GripLoad{});
  }

  EXPECT_LT(storedEnergy_J(*scene.rod, pose, nullptr, {}), 0.01 * before_J);
}

TEST(RodTick, AllocatesNothingAndThrowsNothing) {
  const RodScene scene = rodScenes()[5];
  RunningRodScene run(scene);
  static_assert(noexcept(
      stepRod(*scene.rod, nullptr, Pose{}, 1e-3, std::declval<RodPose&>(), std::declval<RodWorkspace&>())));
  static_assert(std::is_trivially_copyable_v<RodStepResult>);
  std::int64_t taken = 0;

  for (int tick = 0; tick < scene.ticks; ++tick) {
    run.moveHand();
    const std::int64_t before = testing::allocationCount();
    run.step();
    taken += testing::allocationCount() - before;
  }

  EXPECT_EQ(taken, 0);
}

TEST(RodBench, TimesTicksThatTurnTheRod) {
  const RodBenchResult result = runRodBench(500);

  EXPECT_GT(result.median_us, 0.0);
  EXPECT_GE(result.p999_us, result.median_us);
  EXPECT_GT(result.turn_rad, radians(30.0));  // the hand turns by 90 degrees, the rod lags behind and gives
  EXPECT_LT(result.turn_rad, radians(100.0));
}

}  // namespace

}  // namespace torsio
