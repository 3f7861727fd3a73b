// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_energy.h"

#include <cmath>
#include <span>

#include "sim/tissue/rod/rod_element.h"

namespace torsio {

namespace {

double clampedShare(double t) noexcept {
  return t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
}

/// Distance of two segments p + s u and q + t v (Ericson, Real-Time Collision Detection, 5.1.9).
double segmentDistance_m(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) noexcept {
  const Vec3 r = p - q;
  const double a = dot(u, u);
  const double e = dot(v, v);
  const double b = dot(u, v);
  const double c = dot(u, r);
  const double f = dot(v, r);
  const double across = a * e - b * b;
  double s = across > 1e-12 * a * e ? clampedShare((b * f - c * e) / across) : 0.0;
  const double t = clampedShare((b * s + f) / e);
  s = clampedShare((b * t - c) / a);
  return norm(r + s * u - t * v);
}

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

void findNearPairs(const Rod& rod, const RodPose& pose, double way_m, NearPairs& near) noexcept {
  std::array<Vec3, kMaxRodNodes> middles;
  std::array<double, kMaxRodNodes> reaches_m;
  const std::span<const double> radii_m = rod.capsuleRadii_m();
  for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(pose.count); ++i) {
    const Vec3& a = pose.nodes[i].position_m;
    const Vec3& b = pose.nodes[i + 1].position_m;
    middles[i] = 0.5 * (a + b);
    reaches_m[i] = radii_m[i] + 0.5 * norm(b - a) + way_m;
  }
  near.count = 0;
  for (const RodContactPair& pair : rod.contactPairs()) {
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    const Vec3 apart = middles[a] - middles[b];
    const double reach_m = reaches_m[a] + reaches_m[b];
    if (dot(apart, apart) <= reach_m * reach_m) {
      near.pairs[static_cast<std::size_t>(near.count++)] = pair;
    }
  }
}

double contactEnergy_J(const Rod& rod, std::span<const RodContactPair> near, const RodPose& pose) noexcept {
  double squares_m2 = 0.0;
  visitContacts(rod, near, pose, [&squares_m2](const RodContact& contact) {
    squares_m2 += contact.depth_m * contact.depth_m;
  });
  return 0.5 * rod.settings().contactStiffness_N_per_m * squares_m2;
}

double deepestOverlap_m(const Rod& rod, const RodPose& pose) noexcept {
  double deepest_m = 0.0;
  for (const RodContactPair& pair : rod.contactPairs()) {
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    const Vec3& p = pose.nodes[a].position_m;
    const Vec3& q = pose.nodes[b].position_m;
    const double apart_m =
        segmentDistance_m(p, pose.nodes[a + 1].position_m - p, q, pose.nodes[b + 1].position_m - q);
    const double overlap_m = rod.capsuleRadii_m()[a] + rod.capsuleRadii_m()[b] - apart_m;
    deepest_m = overlap_m > deepest_m ? overlap_m : deepest_m;
  }
  return deepest_m;
}

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
