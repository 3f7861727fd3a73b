// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_energy.h"

#include <cmath>
#include <span>

#include "sim/tissue/rod/rod_element.h"

namespace torsio {
namespace {

double restraintEnergy_J(const RodRestraints& restraints, const RodPose& pose) noexcept {
  double twice_J = 0.0;
  for (const PointSpring& spring : restraints.points) {
    const Pose& at = pose.nodes[static_cast<std::size_t>(spring.node)];
    const Vec3 way = at.position_m + rotate(at.orientation, spring.arm_m) - spring.anchor_m;
    const double over_m = norm(way) - spring.slack_m;
    if (over_m > 0.0) {
      twice_J += spring.stiffness_N_per_m * over_m * over_m;
    }
  }
  for (const TurnSpring& spring : restraints.turns) {
    const Quat& q = pose.nodes[static_cast<std::size_t>(spring.node)].orientation;
    const Vec3 turn = 4.0 * quarterTangent(conjugate(spring.orientation) * q);
    twice_J += spring.stiffness_Nm_per_rad * dot(turn, turn);
  }
  return 0.5 * twice_J;
}

double gripEnergy_J(const RodGrip& grip, const Pose& hand, const RodPose& pose) noexcept {
  double place_m2 = 0.0;
  double turn_rad2 = 0.0;
  for (int k = 0; k < grip.count; ++k) {
    const GripNode& held = grip.nodes[static_cast<std::size_t>(k)];
    const Pose& at = pose.nodes[static_cast<std::size_t>(held.node)];
    const Vec3 way = at.position_m + rotate(at.orientation, held.arm_m) - hand.position_m;
    const Vec3 turn = 4.0 * quarterTangent(conjugate(hand.orientation * held.handToNode) * at.orientation);
    place_m2 += dot(way, way);
    turn_rad2 += dot(turn, turn);
  }
  const double share = grip.count > 0 ? 0.5 / grip.count : 0.0;
  return share * (grip.stiffness.place_N_per_m * place_m2 + grip.stiffness.turn_Nm_per_rad * turn_rad2);
}

/// Adds what restraints, jaw and contact store to the energy of the elements.
double withSurroundings_J(const RodTask& task, const RodPose& pose, double energy_J) noexcept {
  energy_J += restraintEnergy_J(task.rod->restraints(), pose);
  if (task.grip != nullptr) {
    energy_J += gripEnergy_J(*task.grip, task.hand, pose);
  }
  return energy_J + contactEnergy_J(*task.rod, task.near, pose);
}

}  // namespace

double startEnergy_J(const RodTask& task) noexcept {
  const std::span<const RodElement> elements = task.rod->elements();
  double energy_J = 0.0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    energy_J += elementEnergy_J(elements[i], task.strainsBefore[i]);
  }
  return withSurroundings_J(task, *task.before, energy_J);
}

double stepEnergy_J(const RodTask& task, const RodPose& pose) noexcept {
  const Rod& rod = *task.rod;
  const std::span<const RodElement> elements = rod.elements();
  const double viscous = 0.5 * rod.settings().damping_s * task.rate_per_s;
  double energy_J = 0.0;
  double damped_J = 0.0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const RodElement& e = elements[i];
    const RodStrain strain = rodStrain(e.length_m, pose.nodes[i], pose.nodes[i + 1]);
    energy_J += elementEnergy_J(e, strain);
    if (task.rate_per_s > 0.0) {
      const RodStrain& before = task.strainsBefore[i];
      damped_J += viscous * e.length_m *
                  stiffnessForm(e, e.axial_N, strain.stretch - before.stretch,
                                strain.curvature_per_m - before.curvature_per_m);
    }
  }
  if (task.rate_per_s > 0.0) {
    double way_m2 = 0.0;
    for (std::size_t i = 0; i <= elements.size(); ++i) {
      const Vec3 way = pose.nodes[i].position_m - task.before->nodes[i].position_m;
      way_m2 += dot(way, way);
    }
    damped_J += 0.5 * rod.settings().drag_Ns_per_m * task.rate_per_s * way_m2;
  }
  return withSurroundings_J(task, pose, energy_J) + damped_J;
}

double storedEnergy_J(const Rod& rod, const RodPose& pose, const RodGrip* grip, const Pose& hand) noexcept {
  return stepEnergy_J({.rod = &rod, .grip = grip, .hand = hand, .near = rod.contactPairs()}, pose);
}

}  // namespace torsio
