// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/grip.h"

#include "sim/tissue/rod/rod_algebra.h"

namespace torsio {

RodGrip gripAt(const Rod& rod, const RodPose& pose, int node, double halfWidth_m, const Pose& hand,
               const GripStiffness& stiffness) noexcept {
  double arc_m = 0.0;
  for (int i = 0; i < node; ++i) {
    arc_m += rod.elements()[static_cast<std::size_t>(i)].length_m;
  }
  const NodeRange patch = nodesAround(rod.elements(), arc_m, halfWidth_m, kMaxGripNodes);
  RodGrip grip;
  grip.stiffness = stiffness;
  for (int i = patch.first; i <= patch.last; ++i) {
    const Pose& at = pose.nodes[static_cast<std::size_t>(i)];
    grip.nodes[static_cast<std::size_t>(grip.count++)] = {
        .node = i,
        .arm_m = rotate(conjugate(at.orientation), hand.position_m - at.position_m),
        .handToNode = conjugate(hand.orientation) * at.orientation};
  }
  return grip;
}

GripLoad gripLoad(const RodGrip& grip, const RodPose& pose, const Pose& hand) noexcept {
  GripLoad load;
  for (int k = 0; k < grip.count; ++k) {
    const GripNode& held = grip.nodes[static_cast<std::size_t>(k)];
    const Pose& at = pose.nodes[static_cast<std::size_t>(held.node)];
    const Vec3 sigma = quarterTangent(conjugate(hand.orientation * held.handToNode) * at.orientation);
    load.force_N += at.position_m + rotate(at.orientation, held.arm_m) - hand.position_m;
    load.torque_Nm += rotate(at.orientation, transposedTimes(turnRate(sigma), 4.0 * sigma));
  }
  const double share = grip.count > 0 ? 1.0 / grip.count : 0.0;
  load.force_N *= share * grip.stiffness.place_N_per_m;
  load.torque_Nm *= share * grip.stiffness.turn_Nm_per_rad;
  return load;
}

}  // namespace torsio
