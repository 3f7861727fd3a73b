// SPDX-License-Identifier: GPL-3.0-or-later
// A rod that touches itself.
#include "sim/tissue/rod/rod_contact.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "sim/tissue/rod/rod_solve.h"
#include "sim/tissue/rod/rod_step.h"
#include "tests/sim/tissue/rod/rod_organs.h"
#include "tests/sim/tissue/rod/rod_scenes.h"

namespace torsio {
namespace {

/// The loop without contact: no radii.
Rod ghost(const Rod& loop) {
  return Rod(std::vector<RodElement>(loop.elements().begin(), loop.elements().end()), loop.rest(),
             std::vector<double>(static_cast<std::size_t>(loop.nodeCount()), 0.0), loop.restraints());
}

/// Depth of one limb of the loop in the other, measured with the radii of `loop`, after `ticks` of a hand
/// that carries the jaw of `rod` by 60 mm towards the other limb.
double pressed_m(const Rod& rod, const Rod& loop, int ticks, double& force_N) {
  RodPose pose = rod.rest();
  const auto work = std::make_unique<RodWorkspace>();
  Pose hand = pose.nodes[7];
  const RodGrip grip = gripAt(rod, pose, 7, 0.006, hand, {});
  double deepest_m = 0.0;
  for (int tick = 0; tick < ticks; ++tick) {
    hand.position_m.x += 0.090 / ticks;
    force_N = norm(stepRod(rod, &grip, hand, 1e-3, pose, *work).load.force_N);
    deepest_m = std::max(deepest_m, deepestOverlap_m(loop, pose));
  }
  return deepest_m;
}

TEST(RodContact, KeepsTwoPressedLimbsApartToThreeTenthsOfAMillimetre) {
  const Rod loop = bowelLoop(0.012, 0.010);
  double force_N = 0.0;
  double unused_N = 0.0;

  const double with_m = pressed_m(loop, loop, 1000, force_N);
  const double without_m = pressed_m(ghost(loop), loop, 1000, unused_N);

  EXPECT_GT(force_N, 1.0);
  EXPECT_GT(with_m, 0.0);
  EXPECT_LT(with_m, 3e-4);
  EXPECT_GT(without_m, 5e-3);
}

TEST(RodContact, PairsThatAreLeftOutTouchNowhere) {
  // Given a loop that a hand turns upside down, limbs lying on each other on the way.
  const Rod loop = bowelLoop(0.022, 0.020);
  RodPose pose = loop.rest();
  const auto work = std::make_unique<RodWorkspace>();
  const Pose rest = pose.nodes[16];
  const RodGrip grip = gripAt(loop, pose, 16, 0.006, rest, {});
  const auto radii_m = loop.capsuleRadii_m();
  int touching = 0;
  int apart = 0;
  for (int tick = 0; tick < 600; ++tick) {
    const Quat turn = axisAngle({0, 0, 1}, 2.0 * kPi * tick / 600.0);
    stepRod(loop, &grip, {rest.position_m, turn * rest.orientation}, 1e-3, pose, *work);

    for (const RodContactPair& pair : loop.contactPairs()) {
      const double reach_m =
          radii_m[static_cast<std::size_t>(pair.first)] + radii_m[static_cast<std::size_t>(pair.second)];
      const bool left = farApart(pose, pair.first, pair.second, reach_m);
      RodContact contact;
      bool touched = false;
      for (const double share : {0.0, 0.5, 1.0}) {
        touched = touched || touches(pose, pair.first, share, pair.second, reach_m, contact) ||
                  touches(pose, pair.second, share, pair.first, reach_m, contact);
      }
      EXPECT_FALSE(left && touched) << tick << ": " << pair.first << ", " << pair.second;
      touching += touched ? 1 : 0;
      apart += left ? 1 : 0;
    }
  }

  EXPECT_GT(touching, 100);
  EXPECT_GT(apart, touching);
}

TEST(RodContact, HoldsAtRestToo) {
  const Rod loop = bowelLoop(0.012, 0.010);
  RodPose pose = loop.rest();
  Pose hand = pose.nodes[7];
  const RodGrip grip = gripAt(loop, pose, 7, 0.006, hand, {});
  RodBalance balance;

  for (int step = 1; step <= 18; ++step) {
    hand.position_m.x += 0.005;
    balance = balanceRod(loop, &grip, hand, {}, pose);
    ASSERT_TRUE(balance.converged) << step << " residual " << balance.residual;
    EXPECT_LT(deepestOverlap_m(loop, pose), 3e-4);
  }

  EXPECT_GT(norm(balance.load.force_N), 1.0);
  EXPECT_GT(deepestOverlap_m(loop, pose), 0.0);
}

TEST(RodContact, HoldsWhileTheLimbsSlide) {
  const RodScene scene = rodScenes()[5];
  RunningRodScene run(scene);
  double deepest_m = 0.0;

  for (int tick = 0; tick < scene.ticks; ++tick) {
    run.moveHand();
    run.step();
    deepest_m = std::max(deepest_m, deepestOverlap_m(*scene.rod, run.pose()));
  }

  EXPECT_GT(deepest_m, 0.0);
  EXPECT_LT(deepest_m, 3e-4);
}

TEST(RodContact, LeavesAloneWhatLiesTogetherAtRest) {
  const Rod stomach = stomachRod();
  const Rod tight = bowelLoop(0.012, -0.002);  // limbs that overlap as imported

  EXPECT_EQ(contactEnergy_J(stomach, stomach.contactPairs(), stomach.rest()), 0.0);
  EXPECT_EQ(contactEnergy_J(tight, tight.contactPairs(), tight.rest()), 0.0);
  EXPECT_FALSE(stomach.contactPairs().empty());
  for (const RodContactPair& pair : stomach.contactPairs()) {
    EXPECT_LT(pair.first + 1, pair.second);
  }
}

TEST(RodContact, FindsEveryPairThatCanTouchWithinTheWayGiven) {
  const Rod loop = bowelLoop(0.012, 0.010);
  const auto near = std::make_unique<NearPairs>();

  findNearPairs(loop, loop.rest(), 0.0, *near);
  const int touching = near->count;
  findNearPairs(loop, loop.rest(), 0.006, *near);
  const int within = near->count;

  EXPECT_EQ(touching, 0);  // 10 mm apart
  EXPECT_GT(within, 10);
  EXPECT_LT(within, static_cast<int>(loop.contactPairs().size()));
}

}  // namespace
}  // namespace torsio
