// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "sim/core/organ_pose.h"
#include "sim/tissue/rod/rod.h"
#include "sim/tissue/rod/rod_system.h"

namespace torsio {

/// What a tick is allowed (docs/model.md R.6). They decide the pose, hence belong to the rules of a
/// recording.
struct RodStepRules {
  int newtonSteps = 2;
  int halvings = 6;
  int contactIterations = 6;       ///< conjugate gradients a Newton step
  double turn_rad = 0.3;           ///< longest turn of a node in a Newton step
  double way_m = 0.003;            ///< longest way of a node in a Newton step
  double pivotFloor = 1e-3;        ///< of the stiffness of the element beside
  double settledForce_N = 1e-3;    ///< unbalanced force at a node that is let stand
  double settledMoment_Nm = 3e-5;  ///< unbalanced moment at a node that is let stand
  double settledTurn_rad = 4e-3;   ///< a whole Newton step that turns no node further is the last one
  double settledWay_m = 3e-4;      ///< nor moves one further
};

/// How a tick ended.
enum class RodStepStatus : std::uint8_t {
  kAtRest,    ///< nothing to do: all nodes in balance
  kMoved,     ///< the energy fell
  kKept,      ///< no step lowered the energy: the pose is as before
  kHandLost,  ///< the hand's pose was not finite: the pose is as before, the load zero
};

/// Outcome of one tick.
struct RodStepResult {
  RodStepStatus status = RodStepStatus::kAtRest;
  std::uint8_t newtonSteps = 0;
  std::uint8_t halvings = 0;
  GripLoad load;  ///< on the hand; zero without a jaw
};

/// Arrays of a tick: fixed size, to be made once. One thread.
struct RodWorkspace {
  RodPose before;
  RodPose trial;
  std::array<RodStrain, kMaxRodNodes> strainsBefore{};
  NearPairs near;
  RodSystem system;
  RodSearch search;
  NodeVector step{};
};

/// Moves `pose` on by one tick of `duration_s` > 0 with the jaw `grip` (null: open) held by the hand at
/// `hand`: at most RodStepRules::newtonSteps Newton steps down the energy stepEnergy_J(). The stored energy
/// grows by no more than the hand's work on the coupling, converged or not: a step that does not lower the
/// energy is not taken. Real time: no allocation, no exception, the same bits in every build.
RodStepResult stepRod(const Rod& rod, const RodGrip* grip, const Pose& hand, double duration_s, RodPose& pose,
                      RodWorkspace& work, const RodStepRules& rules = {}) noexcept;

/// Moves every node of `from` by `share` of `step` into `to`: x + dx, q cay(theta). Real time.
void moveNodes(const RodPose& from, const NodeVector& step, double share, RodPose& to) noexcept;

}  // namespace torsio
