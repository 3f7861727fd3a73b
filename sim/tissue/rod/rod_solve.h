// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/tissue/rod/rod.h"

namespace torsio {

/// How a pose at rest was found.
struct RodBalance {
  int newtonSteps = 0;
  bool converged = false;
  double residual = 0.0;   ///< largest unbalanced moment (forces times the element) over the largest moment
  int negativePivots = 0;  ///< of the last stiffness: 0 for a stable pose
  double energy_J = 0.0;
  GripLoad load;  ///< on the hand
  std::vector<GripLoad>
      held;  ///< what holds each of the given nodes: force, moment about the node; world frame
};

/// Moves `pose` to a pose at rest of `rod` near it, down the stored energy, with `held` nodes kept where they
/// are and the jaw `grip` (null: none) at `hand`. Not for the tick.
[[nodiscard]] RodBalance balanceRod(const Rod& rod, const RodGrip* grip, const Pose& hand,
                                    std::span<const HeldNode> held, RodPose& pose);

/// How a section is turned about its own tangent at rest.
struct RodTurn {
  double angle_rad = 0.0;
  int node = -1;           ///< the turned section; -1: the last
  bool holdsPlace = true;  ///< whether its place is held (an end moved as a rigid body) or follows
  /// Half the width of a jaw: the sections within it along the rod (nodesAround) turn with the section as one
  /// rigid body; 0: the section alone.
  double halfWidth_m = 0.0;
};

/// Returns the turn of a section from `rest` to `now` about its tangent `axis` at rest (unit, world frame),
/// what is left beside a swing of the tangent: of all whole turns the one nearest to `before_rad`.
[[nodiscard]] double sectionTurn_rad(const Quat& rest, const Quat& now, const Vec3& axis,
                                     double before_rad) noexcept;

/// Pose at rest of a turned rod.
struct TurnedRod {
  RodPose pose;
  std::vector<double> arc_m;     ///< of each node, along the rod at rest
  std::vector<double> turn_rad;  ///< of each section about its own tangent at rest; counts whole turns
  double torque_Nm = 0.0;        ///< on the turned section or jaw, about its tangent at rest
  double overlap_m = 0.0;     ///< how far the rod overlaps itself: 0 unless parts are pressed on each other
  GripLoad end;               ///< on the turned section or jaw: force, moment about its node; world frame
  RodBalance balance;         ///< of the last step; newtonSteps of all
  double balanced_rad = 0.0;  ///< the last angle up to which every step came to rest
};

/// Turns a section of `rod` about its own tangent at rest, in steps of at most 5 degrees, the first section
/// clamped. `balance.converged` tells whether the last pose is at rest. Not for the tick.
[[nodiscard]] TurnedRod solveTurned(const Rod& rod, const RodTurn& turn);

}  // namespace torsio
