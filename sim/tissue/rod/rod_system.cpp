// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_system.h"

#include <cmath>
#include <span>

#include "sim/tissue/rod/rod_element.h"

namespace torsio {
namespace {

void addVector(Freedoms& to, int at, const Vec3& v) noexcept {
  const auto k = static_cast<std::size_t>(at);
  to[k] += v.x;
  to[k + 1] += v.y;
  to[k + 2] += v.z;
}
void addBlock(Block6& to, int row, int column, const Mat3& a) noexcept {
  double* at = to.data() + 6 * row + column;
  at[0] += a.xx;
  at[1] += a.xy;
  at[2] += a.xz;
  at[6] += a.yx;
  at[7] += a.yy;
  at[8] += a.yz;
  at[12] += a.zx;
  at[13] += a.zy;
  at[14] += a.zz;
}
/// Adds `a` at (row, column) and its transpose at (column, row) of a symmetric block.
void addPair(Block6& to, int row, int column, const Mat3& a) noexcept {
  addBlock(to, row, column, a);
  addBlock(to, column, row, transposed(a));
}
constexpr Mat3 symmetricPart(const Mat3& a) noexcept {
  return 0.5 * (a + transposed(a));
}

/// Turns moment and stiffness that belong to kappa into those that belong to 4 sigma / h. With kappa = 4 f
/// sigma / h and M = f I + 2 f' sigma sigma^T: M m, X M, M C M + (h/4) dM/dsigma m.
void bySigma(const Vec3& sigma, double h, ElementStress& stress) noexcept {
  const AngleScale scale = angleScale(dot(sigma, sigma));
  const Vec3 m = stress.moment_Nm;
  const double along = dot(sigma, m);
  const double f = scale.f;
  const double twice = 2.0 * scale.slope;
  const Vec3 bent = stress.bend_Nm2 * sigma;
  stress.moment_Nm = f * m + (twice * along) * sigma;
  stress.coupling_Nm = f * stress.coupling_Nm + outer(twice * (stress.coupling_Nm * sigma), sigma);
  const Vec3 side = (twice * f) * bent + (0.5 * h * scale.slope) * m;
  const double both = twice * twice * dot(sigma, bent) + h * scale.bend * along;
  const Mat3 mixed = outer(side, sigma);
  stress.bend_Nm2 = (f * f) * stress.bend_Nm2 + mixed + transposed(mixed) + outer(both * sigma, sigma) +
                    scaledIdentity(0.5 * h * scale.slope * along);
}

/// Derivatives of one element by the turns of its nodes (docs/model.md R.4). P = (I - [s x])/2 turns the
/// middle with the first node, P^T with the second.
struct TurnBlocks {
  Mat3 first, second, across;
};

TurnBlocks turnBlocks(const ElementStress& stress, const Vec3& stretch, const Vec3& sigma, const Vec3& c,
                      double h) noexcept {
  const Mat3 b = turnRate(sigma);
  const Mat3 bt = transposed(b);
  const Vec3& m = stress.moment_Nm;
  const double perLength = 1.0 / h;
  // D+- / 4 with [c x]/8: what turns the moments themselves.
  const Mat3 even = scaledIdentity(0.5 * dot(sigma, m)) + 0.5 * (outer(sigma, m) - outer(m, sigma));
  const Mat3 odd = crossMatrix(0.5 * m);
  const Mat3 swing = crossMatrix(0.125 * c);
  const Mat3 stretchTurn = crossTimes(stretch, stress.coupling_Nm);  // Y = [G x] X
  const Mat3 forceTurn =                                             // h ([n x] - [G x] A) [G x]
      timesCross(h * (crossMatrix(stress.force_N) - crossTimes(stretch, stress.stretch_N)), stretch);
  const auto half = [&sigma](const Mat3& a, double sign) {  // a P (sign -1) or a P^T (+1)
    const Mat3 turned = timesCross(a, sigma);
    return 0.5 * (sign < 0.0 ? a - turned : a + turned);
  };
  const auto halfBefore = [&sigma](const Mat3& a, double sign) {  // P a (sign -1) or P^T a (+1)
    const Mat3 turned = crossTimes(sigma, a);
    return 0.5 * (sign < 0.0 ? a - turned : a + turned);
  };
  const Mat3 yt = transposed(stretchTurn);
  const Mat3 u = even - odd + swing + perLength * (b * stress.bend_Nm2) + halfBefore(stretchTurn, 1.0);
  const Mat3 v = b * yt + halfBefore(forceTurn, 1.0);
  const Mat3 u2 = even + odd + swing + perLength * (bt * stress.bend_Nm2) - halfBefore(stretchTurn, -1.0);
  const Mat3 v2 = halfBefore(forceTurn, -1.0) - bt * yt;
  return {.first = symmetricPart(u * bt + half(v, -1.0)),
          .second = symmetricPart(u2 * b + half(v2, 1.0)),
          .across = half(v, 1.0) - u * b};
}

void addElement(const RodTask& task, const RodPose& pose, std::size_t i, RodSystem& system) noexcept {
  const RodElement& e = task.rod->elements()[i];
  const double h = e.length_m;
  const double perLength = 1.0 / h;
  const Pose& p = pose.nodes[i];
  const Pose& q = pose.nodes[i + 1];
  const Vec3 sigma = quarterTangent(conjugate(p.orientation) * q.orientation);
  const Mat3 r = rotationMatrix(p.orientation * unitFrom(sigma));
  const RodStrain strain{.stretch = transposedTimes(r, perLength * (q.position_m - p.position_m)),
                         .curvature_per_m = (4.0 * perLength * angleScale(dot(sigma, sigma)).f) * sigma};
  const bool damped = task.rate_per_s > 0.0;
  const double viscous = task.rod->settings().damping_s * task.rate_per_s;
  ElementStress stress = elementStress(e, strain, viscous, damped ? task.strainsBefore[i] : strain);
  bySigma(sigma, h, stress);

  const Vec3 c = h * cross(stress.force_N, strain.stretch);
  const Vec3 turned = cross(sigma, c);
  const Mat3 b = turnRate(sigma);
  const Vec3 force = r * stress.force_N;
  addVector(system.gradient[i], 0, -force);
  addVector(system.gradient[i], 3, 0.5 * (c + turned) - b * stress.moment_Nm);
  addVector(system.gradient[i + 1], 0, force);
  addVector(system.gradient[i + 1], 3, 0.5 * (c - turned) + transposedTimes(b, stress.moment_Nm));

  const Mat3 turns = r * (timesCross(stress.stretch_N, strain.stretch) - crossMatrix(stress.force_N));
  const Mat3 bends = perLength * (r * stress.coupling_Nm);
  const Mat3 turnsAcross = timesCross(turns, sigma);
  const Mat3 byFirst = 0.5 * (turns - turnsAcross) - bends * transposed(b);
  const Mat3 bySecond = 0.5 * (turns + turnsAcross) + bends * b;
  const Mat3 places = perLength * (r * stress.stretch_N * transposed(r));
  const TurnBlocks blocks = turnBlocks(stress, strain.stretch, sigma, c, h);
  Block6& first = system.diagonal[i];
  Block6& second = system.diagonal[i + 1];
  Block6& across = system.coupling[i];
  addBlock(first, 0, 0, places);
  addBlock(second, 0, 0, places);
  addPair(first, 0, 3, -1.0 * byFirst);
  addPair(second, 0, 3, bySecond);
  addBlock(first, 3, 3, blocks.first);
  addBlock(second, 3, 3, blocks.second);
  addBlock(across, 0, 0, -1.0 * places);
  addBlock(across, 0, 3, -1.0 * bySecond);
  addBlock(across, 3, 0, transposed(byFirst));
  addBlock(across, 3, 3, blocks.across);
}

/// Adds a spring of stiffness `k` from the point `arm` of a section by `way`, stretched beyond `slack`.
void addPointSpring(const Pose& at, const Vec3& arm_m, const Vec3& anchor_m, double slack_m, double k,
                    std::size_t node, RodSystem& system) noexcept {
  const Vec3 way = at.position_m + rotate(at.orientation, arm_m) - anchor_m;
  const double length = norm(way);
  if (!(length > slack_m)) {
    return;
  }
  const Mat3 lever = -1.0 * timesCross(rotationMatrix(at.orientation), arm_m);  // d(R arm) by the turn
  const double stretch = slack_m > 0.0 ? 1.0 - slack_m / length : 1.0;
  const Vec3 force = (k * stretch) * way;
  Mat3 stiffness = scaledIdentity(k * stretch);
  if (slack_m > 0.0) {
    stiffness = stiffness + (k * (1.0 - stretch) / (length * length)) * outer(way, way);
  }
  addVector(system.gradient[node], 0, force);
  addVector(system.gradient[node], 3, transposedTimes(lever, force));
  const Mat3 mixed = stiffness * lever;
  // d(R arm) turns with the section: the part of the stiffness that the force itself makes.
  const Vec3 own = rotate(conjugate(at.orientation), force);
  const Mat3 turning = transposed(lever) * mixed + symmetricPart(crossMatrix(arm_m) * crossMatrix(own));
  addBlock(system.diagonal[node], 0, 0, stiffness);
  addPair(system.diagonal[node], 0, 3, mixed);
  addBlock(system.diagonal[node], 3, 3, turning);
}

void addTurnSpring(const Quat& q, const Quat& target, double k, std::size_t node,
                   RodSystem& system) noexcept {
  const Vec3 sigma = quarterTangent(conjugate(target) * q);
  const Mat3 b = turnRate(sigma);
  addVector(system.gradient[node], 3, transposedTimes(b, (4.0 * k) * sigma));
  // B^T B plus sigma's own derivative: D+(sigma, m = 4 k sigma) / 4 B, of which 2 k sigma^2 I stays in the
  // middle.
  addBlock(system.diagonal[node], 3, 3,
           k * (transposed(b) * b) + symmetricPart((0.25 * scaledIdentity(8.0 * k * dot(sigma, sigma)) +
                                                    crossMatrix((2.0 * k) * sigma)) *
                                                   b));
}

void addSprings(const RodTask& task, const RodPose& pose, RodSystem& system) noexcept {
  for (const PointSpring& spring : task.rod->restraints().points) {
    const auto node = static_cast<std::size_t>(spring.node);
    addPointSpring(pose.nodes[node], spring.arm_m, spring.anchor_m, spring.slack_m, spring.stiffness_N_per_m,
                   node, system);
  }
  for (const TurnSpring& spring : task.rod->restraints().turns) {
    const auto node = static_cast<std::size_t>(spring.node);
    addTurnSpring(pose.nodes[node].orientation, spring.orientation, spring.stiffness_Nm_per_rad, node,
                  system);
  }
  if (task.grip == nullptr || task.grip->count == 0) {
    return;
  }
  const RodGrip& grip = *task.grip;
  const double share = 1.0 / grip.count;
  for (int k = 0; k < grip.count; ++k) {
    const GripNode& held = grip.nodes[static_cast<std::size_t>(k)];
    const auto node = static_cast<std::size_t>(held.node);
    addPointSpring(pose.nodes[node], held.arm_m, task.hand.position_m, 0.0,
                   share * grip.stiffness.place_N_per_m, node, system);
    addTurnSpring(pose.nodes[node].orientation, task.hand.orientation * held.handToNode,
                  share * grip.stiffness.turn_Nm_per_rad, node, system);
  }
}

void addDrag(const RodTask& task, const RodPose& pose, RodSystem& system) noexcept {
  const double k = task.rod->settings().drag_Ns_per_m * task.rate_per_s;
  if (!(k > 0.0)) {
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(pose.count); ++i) {
    addVector(system.gradient[i], 0, k * (pose.nodes[i].position_m - task.before->nodes[i].position_m));
    addBlock(system.diagonal[i], 0, 0, scaledIdentity(k));
  }
}

/// Adds `k` c1 c1^T and `k` c2 c2^T to the band.
void addContactBound(const RodContact& contact, double k, RodSystem& system) noexcept {
  const Mat3 across = outer(contact.normal, contact.normal);
  for (std::size_t side = 0; side < 4; side += 2) {
    const auto node = static_cast<std::size_t>(contact.nodes[side]);
    const double first = contact.shares[side];
    const double second = contact.shares[side + 1];
    addBlock(system.diagonal[node], 0, 0, (k * first * first) * across);
    addBlock(system.coupling[node], 0, 0, (k * first * second) * across);
    addBlock(system.diagonal[node + 1], 0, 0, (k * second * second) * across);
  }
}

void addContacts(const RodTask& task, const RodPose& pose, RodSystem& system) noexcept {
  const double k = task.rod->settings().contactStiffness_N_per_m;
  visitContacts(*task.rod, task.near, pose, [&](const RodContact& contact) {
    const Vec3 push = (-k * contact.depth_m) * contact.normal;
    for (std::size_t n = 0; n < 4; ++n) {
      addVector(system.gradient[static_cast<std::size_t>(contact.nodes[n])], 0, contact.shares[n] * push);
    }
    if (system.contactCount < kMaxStiffContacts) {
      system.contacts[static_cast<std::size_t>(system.contactCount++)] = contact;
      addContactBound(contact, 2.0 * k, system);
    }
  });
}

void clearFreedom(RodSystem& system, std::size_t node, std::size_t freedom) noexcept {
  Block6& own = system.diagonal[node];
  Block6& next = system.coupling[node];
  for (std::size_t k = 0; k < 6; ++k) {
    own[6 * freedom + k] = 0.0;
    own[6 * k + freedom] = 0.0;
    next[6 * freedom + k] = 0.0;
    if (node > 0) {
      system.coupling[node - 1][6 * k + freedom] = 0.0;
    }
  }
  own[7 * freedom] = 1.0;
  system.reaction[node][freedom] =
      system.held[node][freedom] ? system.reaction[node][freedom] : system.gradient[node][freedom];
  system.gradient[node][freedom] = 0.0;
  system.held[node][freedom] = true;
}

void hold(std::span<const HeldNode> nodes, RodSystem& system) noexcept {
  for (const HeldNode& held : nodes) {
    for (std::size_t k = 0; k < 6; ++k) {
      if (held.freedoms[k]) {
        clearFreedom(system, static_cast<std::size_t>(held.node), k);
      }
    }
  }
}

void setFloors(const Rod& rod, double pivotFloor, RodSystem& system) noexcept {
  const std::span<const RodElement> elements = rod.elements();
  for (std::size_t i = 0; i <= elements.size(); ++i) {
    const RodElement& e = elements[i == 0 ? 0 : i - 1];
    system.floors[i] = {pivotFloor * e.stretch_N[0] / e.length_m, pivotFloor * e.bend_Nm2[0] / e.length_m};
  }
}

}  // namespace

void assemble(const RodTask& task, const RodPose& pose, double pivotFloor, RodSystem& system) noexcept {
  system.count = pose.count;
  system.contactCount = 0;
  system.contactStiffness_N_per_m = task.rod->settings().contactStiffness_N_per_m;
  for (std::size_t i = 0; i < static_cast<std::size_t>(pose.count); ++i) {
    system.gradient[i] = {};
    system.diagonal[i] = {};
    system.coupling[i] = {};
    system.held[i] = {};
  }
  for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(pose.count); ++i) {
    addElement(task, pose, i, system);
  }
  addDrag(task, pose, system);
  addSprings(task, pose, system);
  addContacts(task, pose, system);
  hold(task.rod->restraints().held, system);
  hold(task.held, system);
  setFloors(*task.rod, pivotFloor, system);
}

}  // namespace torsio
