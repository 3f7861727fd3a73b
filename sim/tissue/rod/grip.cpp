// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/grip.h"

#include <span>

#include "sim/tissue/rod/rod_algebra.h"

namespace torsio {

RodGrip gripAt(const Rod& rod, const RodPose& pose, int node, double halfWidth_m, const Pose& hand,
               const GripStiffness& stiffness) noexcept {
  const std::span<const RodElement> elements = rod.elements();
  int first = node;
  int last = node;
  double below_m = 0.0;
  double above_m = 0.0;
  bool grew = true;
  while (grew) {  // one node on each side, so that the patch stays symmetric about the node
    grew = false;
    if (first > 0 && last - first + 1 < kMostGripNodes) {
      below_m += elements[static_cast<std::size_t>(first - 1)].length_m;
      grew = below_m <= halfWidth_m;
      first -= grew ? 1 : 0;
    }
    if (last + 1 < pose.count && last - first + 1 < kMostGripNodes) {
      above_m += elements[static_cast<std::size_t>(last)].length_m;
      const bool more = above_m <= halfWidth_m;
      last += more ? 1 : 0;
      grew = grew || more;
    }
  }
  RodGrip grip;
  grip.stiffness = stiffness;
  for (int i = first; i <= last; ++i) {
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
