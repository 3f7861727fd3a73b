// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_solve.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/tissue/rod/rod_element.h"
#include "sim/tissue/rod/rod_step.h"

namespace torsio {
namespace {

constexpr int kMaxNewtonSteps = 400;
constexpr double kBalanced = 1e-11;       ///< residual that ends the solve at once
constexpr double kBalancedEnough = 1e-7;  ///< residual that rounding may leave
constexpr double kLongestSolveTurn_rad = 0.5;
constexpr double kLongestSolveWay = 0.1;  ///< of the length of the rod
constexpr int kSolveHalvings = 30;

/// Largest moment in the rod, and the largest that its nodes do not balance; forces count times the element.
struct Unbalance {
  double carried_Nm = 0.0;
  double left_Nm = 0.0;
};

Unbalance unbalanceOf(const Rod& rod, const RodPose& pose, const NodeVector& gradient) {
  Unbalance u;
  double stiffest_Nm = 0.0;
  for (std::size_t i = 0; i < rod.elements().size(); ++i) {
    const RodElement& e = rod.elements()[i];
    const RodStrain strain = rodStrain(e.length_m, pose.nodes[i], pose.nodes[i + 1]);
    const ElementStress stress = elementStress(e, strain, 0.0, strain);
    u.carried_Nm = std::max(u.carried_Nm, norm(stress.moment_Nm) + e.length_m * norm(stress.force_N));
    stiffest_Nm = std::max(stiffest_Nm, e.bend_Nm2[0] / e.length_m);
    for (const std::size_t node : {i, i + 1}) {
      const Freedoms& g = gradient[node];
      for (std::size_t k = 0; k < 3; ++k) {
        u.left_Nm = std::max({u.left_Nm, e.length_m * std::abs(g[k]), std::abs(g[k + 3])});
      }
    }
  }
  u.carried_Nm += 1e-6 * stiffest_Nm;
  return u;
}

struct LineSearch {
  double share = 1.0;
  bool found = false;
};

/// Halves the step until the energy falls; takes it whole where the fall is too small to be seen in the
/// energy.
LineSearch searchAlong(const RodTask& task, const RodPose& pose, double energy_J, double slope, double share,
                       RodWorkspace& work) {
  if (-slope <= 1e-10 * (std::abs(energy_J) + 1e-30) && share >= 1.0) {
    moveNodes(pose, work.step, 1.0, work.trial);
    return {.share = 1.0, .found = true};
  }
  for (int halving = 0; halving <= kSolveHalvings; ++halving) {
    moveNodes(pose, work.step, share, work.trial);
    if (stepEnergy_J(task, work.trial) <= energy_J + 1e-4 * share * slope) {
      return {.share = share, .found = true};
    }
    share *= 0.5;
  }
  return {};
}

double longestShare(const NodeVector& step, int count, double way_m) {
  double most = 1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      most = std::max({most, std::abs(step[i][k]) / way_m, std::abs(step[i][k + 3]) / kLongestSolveTurn_rad});
    }
  }
  return 1.0 / most;
}

double slopeAlong(const RodWorkspace& work, int count) {
  double slope = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      slope += work.system.gradient[i][k] * work.step[i][k];
    }
  }
  return slope;
}

Vec3 part(const Freedoms& f, std::size_t at) {
  return {f[at], f[at + 1], f[at + 2]};
}

double lengthOf(const Rod& rod) {
  double length_m = 0.0;
  for (const RodElement& e : rod.elements()) {
    length_m += e.length_m;
  }
  return length_m;
}

RodBalance balance(const RodTask& task, RodPose& pose, RodWorkspace& work) {
  const Rod& rod = *task.rod;
  const double longestWay_m = kLongestSolveWay * lengthOf(rod);
  RodBalance result;
  double best = 1e300;
  RodPose bestPose = pose;
  int worse = 0;
  while (true) {
    assemble(task, pose, 1e-10, work.system);
    const Unbalance u = unbalanceOf(rod, pose, work.system.gradient);
    const double residual = u.left_Nm / u.carried_Nm;
    worse = residual < 0.5 * best ? 0 : worse + 1;
    if (residual < best) {
      best = residual;
      bestPose = pose;
    }
    result.negativePivots = factorise(work.system);
    const bool stalled = worse > 3 && best < kBalancedEnough;
    if (residual < kBalanced || stalled || result.newtonSteps >= kMaxNewtonSteps) {
      break;
    }
    solveNewton(work.system, 200, work.search, work.step);
    ++result.newtonSteps;
    const double energy_J = stepEnergy_J(task, pose);
    const LineSearch line = searchAlong(task, pose, energy_J, slopeAlong(work, pose.count),
                                        longestShare(work.step, pose.count, longestWay_m), work);
    if (!line.found) {
      break;
    }
    pose = work.trial;
  }
  pose = bestPose;
  assemble(task, pose, 1e-10, work.system);
  result.residual = best;
  result.converged = best < kBalancedEnough;
  result.energy_J = storedEnergy_J(rod, pose, task.grip, task.hand);
  return result;
}

/// The nodes that turn together, all held as they are.
std::vector<HeldNode> turnedNodes(const Rod& rod, const RodTurn& turn, int node) {
  double arc_m = 0.0;
  for (int i = 0; i < node; ++i) {
    arc_m += rod.elements()[static_cast<std::size_t>(i)].length_m;
  }
  const NodeRange jaw = nodesAround(rod.elements(), arc_m, turn.halfWidth_m, kMaxRodNodes);
  TORSIO_EXPECTS(jaw.first > 0);
  const bool place = turn.holdsPlace;
  std::vector<HeldNode> held;
  for (int i = jaw.first; i <= jaw.last; ++i) {
    held.push_back({.node = i, .freedoms = {place, place, place, true, true, true}});
  }
  return held;
}

}  // namespace

double sectionTurn_rad(const Quat& rest, const Quat& now, const Vec3& axis, double before_rad) noexcept {
  return unwrapNear(turnAbout(axis, rest, now), before_rad);
}

RodBalance balanceRod(const Rod& rod, const RodGrip* grip, const Pose& hand, std::span<const HeldNode> held,
                      RodPose& pose) {
  const auto work = std::make_unique<RodWorkspace>();
  RodTask task{.rod = &rod, .grip = grip, .hand = hand, .near = rod.contactPairs(), .held = held};
  task.hand.orientation = normalized(hand.orientation);
  RodBalance result = balance(task, pose, *work);
  if (grip != nullptr) {
    result.load = gripLoad(*grip, pose, task.hand);
  }
  for (const HeldNode& h : held) {
    const auto node = static_cast<std::size_t>(h.node);
    const Freedoms& reaction = work->system.reaction[node];
    GripLoad load;
    load.force_N = part(reaction, 0);
    load.torque_Nm = rotate(pose.nodes[node].orientation, part(reaction, 3));
    result.held.push_back(load);
  }
  return result;
}

TurnedRod solveTurned(const Rod& rod, const RodTurn& turn) {
  const int turned = turn.node < 0 ? rod.nodeCount() - 1 : turn.node;
  const RodPose& rest = rod.rest();
  const Pose& middle = rest.nodes[static_cast<std::size_t>(turned)];
  const Vec3 axis = rotate(middle.orientation, {0, 0, 1});
  std::vector<HeldNode> held{HeldNode{.node = 0}};
  const std::vector<HeldNode> jaw = turnedNodes(rod, turn, turned);
  held.insert(held.end(), jaw.begin(), jaw.end());
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn.angle_rad) / radians(5.0) - 1e-9)));
  TurnedRod result;
  result.pose = rest;
  const auto count = static_cast<std::size_t>(rest.count);
  result.turn_rad.assign(count, 0.0);
  int newtonSteps = 0;
  bool balanced = true;
  for (int k = 1; k <= steps; ++k) {
    const Quat rotation = axisAngle(axis, turn.angle_rad * k / steps);
    for (const HeldNode& h : jaw) {
      const Pose& was = rest.nodes[static_cast<std::size_t>(h.node)];
      Pose& now = result.pose.nodes[static_cast<std::size_t>(h.node)];
      now.orientation = rotation * was.orientation;
      if (turn.holdsPlace) {
        now.position_m = middle.position_m + rotate(rotation, was.position_m - middle.position_m);
      }
    }
    result.balance = balanceRod(rod, nullptr, {}, held, result.pose);
    newtonSteps += result.balance.newtonSteps;
    balanced = balanced && result.balance.converged;
    if (balanced) {
      result.balanced_rad = turn.angle_rad * k / steps;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Quat& was = rest.nodes[i].orientation;
      result.turn_rad[i] =
          sectionTurn_rad(was, result.pose.nodes[i].orientation, rotate(was, {0, 0, 1}), result.turn_rad[i]);
    }
  }
  result.balance.newtonSteps = newtonSteps;
  const Vec3 about = result.pose.nodes[static_cast<std::size_t>(turned)].position_m;
  for (std::size_t k = 1; k < held.size(); ++k) {
    const GripLoad& load = result.balance.held[k];
    const Vec3 arm = result.pose.nodes[static_cast<std::size_t>(held[k].node)].position_m - about;
    result.end.force_N += load.force_N;
    result.end.torque_Nm += load.torque_Nm + cross(arm, load.force_N);
  }
  result.torque_Nm = dot(result.end.torque_Nm, axis);
  result.overlap_m = deepestOverlap_m(rod, result.pose);
  result.arc_m.push_back(0.0);
  for (const RodElement& e : rod.elements()) {
    result.arc_m.push_back(result.arc_m.back() + e.length_m);
  }
  return result;
}

}  // namespace torsio
