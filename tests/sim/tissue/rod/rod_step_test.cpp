// SPDX-License-Identifier: GPL-3.0-or-later
// The tick: passive, bounded, deaf to nonsense, without allocation.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/tissue/rod/rod_bench.h"
#include "sim/tissue/rod/rod_energy.h"
#include "sim/tissue/rod/rod_solve.h"
#include "tests/sim/tissue/rod/rod_scenes.h"
#include "tests/support/allocation_count.h"

namespace torsio {
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
