// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_step.h"

#include <span>

namespace torsio {
namespace {

constexpr double magnitude(double v) noexcept {
  return v < 0.0 ? -v : v;
}
constexpr double larger(double a, double b) noexcept {
  return a < b ? b : a;
}

/// Largest parts of a node vector: of places and of turns.
struct Extent {
  double place = 0.0;
  double turn = 0.0;
};

Extent extentOf(const NodeVector& v, int count) noexcept {
  Extent extent;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      extent.place = larger(extent.place, magnitude(v[i][k]));
      extent.turn = larger(extent.turn, magnitude(v[i][k + 3]));
    }
  }
  return extent;
}

double slopeOf(const NodeVector& gradient, const NodeVector& step, int count) noexcept {
  double slope = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      slope += gradient[i][k] * step[i][k];
    }
  }
  return slope;
}

/// True for finite places within a kilometre and an orientation that can be made a unit.
bool usable(const Pose& hand) noexcept {
  const Vec3& p = hand.position_m;
  const double turn2 = hand.orientation.w * hand.orientation.w + hand.orientation.x * hand.orientation.x +
                       hand.orientation.y * hand.orientation.y + hand.orientation.z * hand.orientation.z;
  return magnitude(p.x) < 1e3 && magnitude(p.y) < 1e3 && magnitude(p.z) < 1e3 && turn2 > 0.25 && turn2 < 4.0;
}

/// Lowers the energy along work.step; returns the halvings, -1 when no share of the step lowered it.
int descend(const RodTask& task, const RodStepRules& rules, double share, RodPose& pose, double& energy_J,
            RodWorkspace& work) noexcept {
  const double slope = slopeOf(work.system.gradient, work.step, pose.count);
  for (int halving = 0; halving <= rules.halvings; ++halving) {
    moveNodes(pose, work.step, share, work.trial);
    const double trial_J = stepEnergy_J(task, work.trial);
    if (trial_J <= energy_J + 1e-4 * share * slope && trial_J < energy_J) {
      pose = work.trial;
      energy_J = trial_J;
      return halving;
    }
    share *= 0.5;
  }
  return -1;
}

}  // namespace

void moveNodes(const RodPose& from, const NodeVector& step, double share, RodPose& to) noexcept {
  to.count = from.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(from.count); ++i) {
    const Freedoms& d = step[i];
    to.nodes[i].position_m = from.nodes[i].position_m + share * Vec3{d[0], d[1], d[2]};
    to.nodes[i].orientation = turnedBy(from.nodes[i].orientation, share * Vec3{d[3], d[4], d[5]});
  }
}

RodStepResult stepRod(const Rod& rod, const RodGrip* grip, const Pose& hand, double duration_s, RodPose& pose,
                      RodWorkspace& work, const RodStepRules& rules) noexcept {
  RodStepResult result;
  if (grip != nullptr && !usable(hand)) {
    result.status = RodStepStatus::kHandLost;
    return result;
  }
  const Pose held{hand.position_m, grip != nullptr ? normalized(hand.orientation) : Quat{}};
  work.before = pose;
  const std::span<const RodElement> elements = rod.elements();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    work.strainsBefore[i] = rodStrain(elements[i].length_m, pose.nodes[i], pose.nodes[i + 1]);
  }
  findNearPairs(rod, pose, rules.newtonSteps * 1.8 * rules.way_m, work.near);  // way_m bounds each coordinate
  const RodTask task{.rod = &rod,
                     .grip = grip,
                     .hand = held,
                     .near = work.near.all(),
                     .before = &work.before,
                     .strainsBefore = work.strainsBefore,
                     .rate_per_s = 1.0 / duration_s};
  double energy_J = startEnergy_J(task);
  while (result.newtonSteps < rules.newtonSteps) {
    assemble(task, pose, rules.pivotFloor, work.system);
    const Extent unbalanced = extentOf(work.system.gradient, pose.count);
    if (unbalanced.place < rules.settledForce_N && unbalanced.turn < rules.settledMoment_Nm) {
      break;
    }
    factorise(work.system);
    solveNewton(work.system, rules.contactIterations, work.search, work.step);
    const Extent way = extentOf(work.step, pose.count);
    const double tooFar = larger(way.turn / rules.turn_rad, way.place / rules.way_m);
    const double share = tooFar > 1.0 ? 1.0 / tooFar : 1.0;
    ++result.newtonSteps;
    const int halvings = descend(task, rules, share, pose, energy_J, work);
    if (halvings < 0) {
      result.status = result.status == RodStepStatus::kMoved ? result.status : RodStepStatus::kKept;
      result.halvings = static_cast<std::uint8_t>(result.halvings + rules.halvings);
      break;
    }
    result.status = RodStepStatus::kMoved;
    result.halvings = static_cast<std::uint8_t>(result.halvings + halvings);
    if (tooFar <= 1.0 && halvings == 0 && way.turn < rules.settledTurn_rad &&
        way.place < rules.settledWay_m) {
      break;
    }
  }
  if (grip != nullptr) {
    result.load = gripLoad(*grip, pose, held);
  }
  return result;
}

}  // namespace torsio
