// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <type_traits>

#include "sim/tissue/rod/rod.h"

namespace torsio {

/// Most nodes that a jaw may hold.
inline constexpr int kMaxGripNodes = 16;

/// Stiffness of the virtual coupling between hand and rod.
struct GripStiffness {
  double place_N_per_m = 100.0;  ///< 0: only turns, as about the organ's own axis
  double turn_Nm_per_rad = 1.0;  ///< assumed
};

/// One node in the jaw: where the hand was when the jaw closed, in the axes of its section.
struct GripNode {
  int node = 0;
  Vec3 arm_m;       ///< the hand's place
  Quat handToNode;  ///< orientation of the section in the axes of the hand
};

/// A closed jaw: a virtual coupling of six degrees, shared alike by the nodes within half a radius of the
/// place (a single node must not carry a point load). Trivially copyable. Energy, a node:
///   K/(2 n) |x + R arm - hand|^2 + Kr/(2 n) |4 sigma((hand handToNode)* q)|^2.
struct RodGrip {
  int count = 0;
  std::array<GripNode, kMaxGripNodes> nodes{};
  GripStiffness stiffness;
};
static_assert(std::is_trivially_copyable_v<RodGrip>);

/// Closes a jaw over the nodes within `halfWidth_m` of arc length of node `node` of `pose`, the hand standing
/// at `hand`. Real time.
[[nodiscard]] RodGrip gripAt(const Rod& rod, const RodPose& pose, int node, double halfWidth_m,
                             const Pose& hand, const GripStiffness& stiffness) noexcept;

/// What the rod does to the hand: force, and torque about the hand's place, world frame.
struct GripLoad {
  Vec3 force_N;
  Vec3 torque_Nm;
  friend constexpr bool operator==(const GripLoad&, const GripLoad&) = default;
};

/// Returns the load on the hand at `hand`. Real time.
[[nodiscard]] GripLoad gripLoad(const RodGrip& grip, const RodPose& pose, const Pose& hand) noexcept;

}  // namespace torsio
