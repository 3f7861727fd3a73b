// SPDX-License-Identifier: GPL-3.0-or-later
// Gradient and stiffness of the rod against differences of its energy; what leaves the energy as it is.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/random.h"
#include "sim/tissue/rod/rod_step.h"
#include "sim/tissue/rod/rod_system.h"
#include "tests/sim/tissue/rod/rod_organs.h"
#include "tests/sim/tissue/rod/rod_shapes.h"

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
    RodElement e;
    e.length_m = 1.0 + 0.1 * draw();
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

}  // namespace
}  // namespace torsio
