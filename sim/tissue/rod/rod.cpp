// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sim/core/contracts.h"
#include "sim/tissue/rod/rod_algebra.h"

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

namespace {

/// Two parts of a rod touch only where the way along it is longer than this many sums of their radii: a bend
/// as sharp as the bend limit lets it be does not touch itself nearer.
constexpr double kNearestContactWay = 1.2;
/// Distance at rest over the sum of the radii from which on two elements may touch.
constexpr double kContactFreeAtRest = 1.02;

bool namesNode(int node, int count) {
  return node >= 0 && node < count;
}

Vec3 middleOf(const RodPose& pose, std::size_t element) {
  return 0.5 * (pose.nodes[element].position_m + pose.nodes[element + 1].position_m);
}

std::vector<RodContactPair> freePairs(std::span<const RodElement> elements, const RodPose& rest,
                                      std::span<const double> radii_m) {
  std::vector<RodContactPair> pairs;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    double way_m = 0.0;  // from the end of i to the start of j
    for (std::size_t j = i + 1; j < elements.size(); ++j) {
      const double reach_m = radii_m[i] + radii_m[j];
      const double apart_m =
          norm(middleOf(rest, i) - middleOf(rest, j)) - 0.5 * (elements[i].length_m + elements[j].length_m);
      if (radii_m[i] > 0.0 && radii_m[j] > 0.0 && way_m > kNearestContactWay * reach_m &&
          apart_m > kContactFreeAtRest * reach_m) {
        pairs.push_back({.first = static_cast<std::int16_t>(i), .second = static_cast<std::int16_t>(j)});
      }
      way_m += elements[j].length_m;
    }
  }
  return pairs;
}

}  // namespace

void addShearCentre(RodElement& element, double e1_m, double e2_m) noexcept {
  const double shear1_N = element.stretch_N[0];
  const double shear2_N = element.stretch_N[4];
  element.coupling_Nm[2] -= shear1_N * e2_m;
  element.coupling_Nm[5] += shear2_N * e1_m;
  element.bend_Nm2[8] += shear1_N * e2_m * e2_m + shear2_N * e1_m * e1_m;
}

Rod::Rod(std::vector<RodElement> elements, const RodPose& rest, std::vector<double> radii_m,
         RodRestraints restraints, const RodSettings& settings)
    : elements_(std::move(elements)), rest_(rest), restraints_(std::move(restraints)), settings_(settings) {
  const int count = rest_.count;
  TORSIO_EXPECTS(count >= 2 && count <= kMaxRodNodes);
  TORSIO_EXPECTS(elements_.size() + 1 == static_cast<std::size_t>(count));
  TORSIO_EXPECTS(radii_m.size() == static_cast<std::size_t>(count));
  for (const RodElement& e : elements_) {
    TORSIO_EXPECTS(e.length_m > 0.0 && e.restStrain[2] > 0.0);
  }
  for (const PointSpring& spring : restraints_.points) {
    TORSIO_EXPECTS(namesNode(spring.node, count));
  }
  for (const TurnSpring& spring : restraints_.turns) {
    TORSIO_EXPECTS(namesNode(spring.node, count));
  }
  for (const HeldNode& held : restraints_.held) {
    TORSIO_EXPECTS(namesNode(held.node, count));
  }
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    capsuleRadii_m_.push_back(0.5 * (radii_m[i] + radii_m[i + 1]));
  }
  contactPairs_ = freePairs(elements_, rest_, capsuleRadii_m_);
}

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
