// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/restraint.h"

namespace torsio {

void addPatchSpring(const PatchSpring& spring, const RodPose& rest, RodRestraints& restraints) {
  for (int node = spring.nodes.first; node <= spring.nodes.last; ++node) {
    const Pose& at = rest.nodes[static_cast<std::size_t>(node)];
    restraints.points.push_back({.node = node,
                                 .arm_m = rotate(conjugate(at.orientation), spring.point_m - at.position_m),
                                 .anchor_m = spring.anchor_m,
                                 .slack_m = spring.slack_m,
                                 .stiffness_N_per_m = spring.stiffness_N_per_m / spring.nodes.count()});
  }
}

void addPatchTurn(NodeRange nodes, double stiffness_Nm_per_rad, const RodPose& rest,
                  RodRestraints& restraints) {
  for (int node = nodes.first; node <= nodes.last; ++node) {
    restraints.turns.push_back({.node = node,
                                .orientation = rest.nodes[static_cast<std::size_t>(node)].orientation,
                                .stiffness_Nm_per_rad = stiffness_Nm_per_rad / nodes.count()});
  }
}

}  // namespace torsio
