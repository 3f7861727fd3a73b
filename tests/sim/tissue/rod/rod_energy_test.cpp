// SPDX-License-Identifier: GPL-3.0-or-later
// Gradient and stiffness of the rod against differences of its energy; what leaves the energy as it is.
// A rod that touches itself.
#include "sim/tissue/rod/rod_energy.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/random.h"
#include "sim/tissue/rod/rod_solve.h"
#include "sim/tissue/rod/rod_step.h"
#include "sim/tissue/rod/rod_system.h"
#include "tests/sim/tissue/rod/rod_scenes.h"

namespace torsio {
namespace {

/// A rod of six odd elements with every term of the energy, far from its shape at rest.
struct OddRod {
  Random random{7};
  std::unique_ptr<Rod> rod;
  RodPose rest;
  RodPose pose;
  RodGrip grip;
  Pose hand;
  std::vector<RodStrain> strainsBefore;
  RodTask task;

  OddRod() {
    rest = shaken(straightPose(6.0, 6), 0.2, 0.5);
    std::vector<RodElement> elements;
    for (int i = 0; i < 6; ++i) {
      elements.push_back(element());
    }
    restAt(rest, elements);
    RodRestraints held;
    held.points = {
        {.node = 2, .arm_m = {0.1, 0.2, 0.3}, .anchor_m = {1, 2, 3}, .slack_m = 0.5, .stiffness_N_per_m = 2},
        {.node = 1, .arm_m = {0.3, 0.2, -0.3}, .anchor_m = {-1, 2, 3}, .stiffness_N_per_m = 2}};
    held.turns = {
        {.node = 3, .orientation = normalized(Quat{1, 0.2, 0.3, 0.4}), .stiffness_Nm_per_rad = 1.5}};
    rod = std::make_unique<Rod>(elements, rest, std::vector<double>(7, 0.0), held);
    pose = shaken(rest, 0.1, 0.4);
    hand = {.position_m = {0.5, 0.5, 3}, .orientation = normalized(Quat{1, 0.1, 0.1, 0.1})};
    grip = gripAt(*rod, pose, 3, 1.3, hand, {.place_N_per_m = 1, .turn_Nm_per_rad = 2});
    hand.position_m += Vec3{0.2, 0.3, 0.4};
    hand.orientation = normalized(hand.orientation * Quat{1, 0.2, 0, 0.1});
    for (std::size_t i = 0; i < 6; ++i) {
      strainsBefore.push_back(rodStrain(elements[i].length_m, rest.nodes[i], rest.nodes[i + 1]));
    }
    task = {.rod = rod.get(),
            .grip = &grip,
            .hand = hand,
            .near = rod->contactPairs(),
            .before = &rest,
            .strainsBefore = strainsBefore,
            .rate_per_s = 20.0};
  }

  double draw() { return 2.0 * random.uniform() - 1.0; }
  Vec3 drawVector(double size) {
    const double x = draw();
    const double y = draw();
    return size * Vec3{x, y, draw()};
  }
  RodPose shaken(RodPose from, double place_m, double turn_rad) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(from.count); ++i) {
      from.nodes[i].position_m += drawVector(place_m);
      from.nodes[i].orientation = turnedBy(from.nodes[i].orientation, drawVector(turn_rad));
    }
    return from;
  }
  RodElement element() {
    RodElement e{.length_m = 1.0 + 0.1 * draw()};
    for (const std::size_t k : {0U, 4U, 8U}) {
      e.stretch_N[k] = 2.0 + draw();
      e.bend_Nm2[k] = 2.0 + draw();
    }
    for (double& x : e.coupling_Nm) {
      x = 0.2 * draw();
    }
    e.stretch_N[1] = e.stretch_N[3] = 0.1;
    e.bend_Nm2[1] = e.bend_Nm2[3] = 0.1;
    e.axial_N = 2.0;
    e.bendLimit = {.lever_m = {0.3, 0.2}, .spread_m2 = {0.5, 0.1, 0.7}, .limit = 0.1, .stiffness_N = 3.0};
    return e;
  }
};

double energyMoved(const RodTask& task, const RodPose& pose, int a, double da, int b, double db) {
  NodeVector step{};
  step[static_cast<std::size_t>(a / 6)][static_cast<std::size_t>(a % 6)] += da;
  step[static_cast<std::size_t>(b / 6)][static_cast<std::size_t>(b % 6)] += db;
  RodPose moved;
  moveNodes(pose, step, 1.0, moved);
  return stepEnergy_J(task, moved);
}

/// Largest error of the gradient over its largest entry, by differences of fourth order.
double gradientError(const RodTask& task, const RodPose& pose, double e) {
  const auto system = std::make_unique<RodSystem>();
  assemble(task, pose, 0.0, *system);
  double error = 0.0;
  double largest = 0.0;
  for (int a = 0; a < 6 * pose.count; ++a) {
    const auto at = [&](double by) { return energyMoved(task, pose, a, by, a, 0.0); };
    const double slope = (8.0 * (at(e) - at(-e)) - (at(2.0 * e) - at(-2.0 * e))) / (12.0 * e);
    const double given = system->gradient[static_cast<std::size_t>(a / 6)][static_cast<std::size_t>(a % 6)];
    error = std::max(error, std::abs(slope - given));
    largest = std::max(largest, std::abs(slope));
  }
  return error / largest;
}

double entry(const RodSystem& system, int a, int b) {
  const int i = a / 6;
  const int j = b / 6;
  const auto at = [](const Block6& block, int row, int column) {
    return block[static_cast<std::size_t>(6 * (row % 6) + column % 6)];
  };
  if (i == j) {
    return at(system.diagonal[static_cast<std::size_t>(i)], a, b);
  }
  if (j == i + 1) {
    return at(system.coupling[static_cast<std::size_t>(i)], a, b);
  }
  return i == j + 1 ? at(system.coupling[static_cast<std::size_t>(j)], b, a) : 0.0;
}

TEST(RodEnergy, AtTheStartOfAStepIsThatOfThePoseBefore) {
  const OddRod odd;
  ASSERT_GT(odd.task.rate_per_s, 0.0);
  EXPECT_EQ(startEnergy_J(odd.task), stepEnergy_J(odd.task, *odd.task.before));
  EXPECT_NE(startEnergy_J(odd.task), stepEnergy_J(odd.task, odd.pose));
}

TEST(RodEnergy, HasTheGradientThatDifferencesShow) {
  const OddRod odd;

  const double error = gradientError(odd.task, odd.pose, 2e-4);

  EXPECT_LT(error, 1e-9);
}

TEST(RodEnergy, HasTheStiffnessThatSecondDifferencesShow) {
  const OddRod odd;
  const auto system = std::make_unique<RodSystem>();
  double error = 0.0;
  double largest = 0.0;
  constexpr double kBy = 1e-4;

  assemble(odd.task, odd.pose, 0.0, *system);

  for (int a = 0; a < 6 * odd.pose.count; ++a) {
    for (int b = 0; b < 6 * odd.pose.count; ++b) {
      const auto at = [&](double da, double db) { return energyMoved(odd.task, odd.pose, a, da, b, db); };
      const double bend = (at(kBy, kBy) - at(kBy, -kBy) - at(-kBy, kBy) + at(-kBy, -kBy)) / (4.0 * kBy * kBy);
      error = std::max(error, std::abs(bend - entry(*system, a, b)));
      largest = std::max(largest, std::abs(bend));
    }
  }
  EXPECT_LT(error / largest, 1e-6);
}

TEST(RodEnergy, HasTheGradientOfContactThatDifferencesShow) {
  const Rod loop = bowelLoop(0.012, 0.010);
  RodPose pressed = loop.rest();
  for (std::size_t i = 2; i < 9; ++i) {  // one limb pushed obliquely by 16 mm, about 3 mm into the other
    pressed.nodes[i].position_m += Vec3{0.0160, 0.0007 * static_cast<double>(i), 0.001};
  }
  const RodTask task{.rod = &loop, .near = loop.contactPairs()};

  const double error = gradientError(task, pressed, 1e-6);

  ASSERT_GT(contactEnergy_J(loop, loop.contactPairs(), pressed), 1e-3);
  EXPECT_LT(error, 1e-7);
}

TEST(RodEnergy, DoesNotChangeUnderARigidMotion) {
  const Rod stomach = stomachRod();
  const Rod free(std::vector<RodElement>(stomach.elements().begin(), stomach.elements().end()),
                 stomach.rest(), std::vector<double>(static_cast<std::size_t>(stomach.nodeCount()), 0.0));
  OddRod odd;
  const RodPose bent = odd.shaken(stomach.rest(), 0.002, 0.05);
  const Quat turn = normalized(Quat{0.3, -0.5, 0.7, 0.2});
  RodPose moved = bent;

  for (Pose& node : moved.nodes) {
    node = {.position_m = Vec3{0.3, -0.2, 0.5} + rotate(turn, node.position_m),
            .orientation = turn * node.orientation};
  }

  const double energy_J = storedEnergy_J(free, bent, nullptr, {});
  EXPECT_GT(energy_J, 1e-3);
  EXPECT_NEAR(storedEnergy_J(free, moved, nullptr, {}), energy_J, 1e-12 * energy_J);
  RodPose restMoved = stomach.rest();
  for (Pose& node : restMoved.nodes) {
    node = {.position_m = rotate(turn, node.position_m), .orientation = turn * node.orientation};
  }
  EXPECT_LT(storedEnergy_J(free, restMoved, nullptr, {}), 1e-24);
}

TEST(RodEnergy, IsTheSameForTheMirrorImage) {
  const Rod stomach = stomachRod();
  OddRod odd;
  const RodPose bent = odd.shaken(stomach.rest(), 0.002, 0.05);
  // The plane y = 0: places change y, turns change sign but for that about y; e1 and t stay, e2 is turned
  // back. In the strains: stretch 2, curvature 1 and 3 change sign, and so do the products of stiffness that
  // join odd with even.
  std::vector<RodElement> mirrored(stomach.elements().begin(), stomach.elements().end());
  for (RodElement& e : mirrored) {
    e.restStrain[1] = -e.restStrain[1];
    e.restCurvature_per_m[0] = -e.restCurvature_per_m[0];
    e.restCurvature_per_m[2] = -e.restCurvature_per_m[2];
    e.bendLimit.lever_m[1] = -e.bendLimit.lever_m[1];
  }
  const auto mirror = [](RodPose pose) {
    for (Pose& node : pose.nodes) {
      node.position_m.y = -node.position_m.y;
      node.orientation.x = -node.orientation.x;
      node.orientation.z = -node.orientation.z;
    }
    return pose;
  };
  const std::vector<double> noContact(static_cast<std::size_t>(stomach.nodeCount()), 0.0);
  const Rod left(std::vector<RodElement>(stomach.elements().begin(), stomach.elements().end()),
                 stomach.rest(), noContact);
  const Rod right(mirrored, mirror(stomach.rest()), noContact);

  const double energy_J = storedEnergy_J(left, bent, nullptr, {});
  const double mirrored_J = storedEnergy_J(right, mirror(bent), nullptr, {});

  EXPECT_EQ(mirrored_J, energy_J);
}

TEST(RodEnergy, RefusesAnElementSqueezedToNothing) {
  const Rod stomach = stomachRod();
  RodPose squeezed = stomach.rest();

  squeezed.nodes[10].position_m = squeezed.nodes[9].position_m;

  EXPECT_GE(storedEnergy_J(stomach, squeezed, nullptr, {}), 1e30);
}

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
