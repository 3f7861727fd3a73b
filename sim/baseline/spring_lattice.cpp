// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/spring_lattice.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "sim/baseline/equilibrium.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr std::array<std::array<int, 2>, 15> kPrismSprings{{{0, 1},
                                                            {1, 2},
                                                            {2, 0},  // lower triangle
                                                            {3, 4},
                                                            {4, 5},
                                                            {5, 3},  // upper triangle
                                                            {0, 3},
                                                            {1, 4},
                                                            {2, 5},  // along
                                                            {0, 4},
                                                            {1, 3},
                                                            {1, 5},  // both diagonals
                                                            {2, 4},
                                                            {2, 3},
                                                            {0, 5}}};  // of each side

double prismVolume(std::span<const int> cell, std::span<const Vec3> points) {
  const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(cell[k])]; };
  const auto six = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return dot(at(b) - at(a), cross(at(c) - at(a), at(d) - at(a)));
  };
  return (six(0, 1, 2, 5) + six(0, 1, 5, 4) + six(0, 4, 5, 3)) / 6.0;
}

Eigen::Matrix3d outerProduct(const Vec3& a, const Vec3& b) {
  return Eigen::Vector3d(a.x, a.y, a.z) * Eigen::RowVector3d(b.x, b.y, b.z);
}

Eigen::Matrix3d crossProductMatrix(const Vec3& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z, v.y, v.z, 0.0, -v.x, -v.y, v.x, 0.0;
  return m;
}

std::array<Vec3, 4> cornersOf(const VolumeSpring& spring, std::span<const Vec3> places) {
  std::array<Vec3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    corners[k] = places[static_cast<std::size_t>(spring.nodes[k])];
  }
  return corners;
}

}  // namespace

VolumeGradient volumeGradient(const std::array<Vec3, 4>& corners_m) noexcept {
  const Vec3 a = corners_m[1] - corners_m[0];
  const Vec3 b = corners_m[2] - corners_m[0];
  const Vec3 c = corners_m[3] - corners_m[0];
  VolumeGradient result;
  result.byPlace[1] = cross(b, c) / 6.0;
  result.byPlace[2] = cross(c, a) / 6.0;
  result.byPlace[3] = cross(a, b) / 6.0;
  result.byPlace[0] = -(result.byPlace[1] + result.byPlace[2] + result.byPlace[3]);
  result.volume_m3 = dot(a, result.byPlace[1]);
  return result;
}

SpringLattice::SpringLattice(const SweptSolid& solid, const ElasticConstants& constants) {
  checkElasticConstants(constants);
  const SolidMesh prisms = linearWedges(solid);
  std::map<std::array<int, 2>, double> shares;  // of the volume
  for (std::size_t c = 0; c < prisms.cells(); ++c) {
    const std::span<const int> cell = prisms.cell(c);
    const double share = prismVolume(cell, solid.points_m) / static_cast<double>(kPrismSprings.size());
    for (const std::array<int, 2>& spring : kPrismSprings) {
      const int a = cell[static_cast<std::size_t>(spring[0])];
      const int b = cell[static_cast<std::size_t>(spring[1])];
      shares[{std::min(a, b), std::max(a, b)}] += share;
    }
  }
  for (const auto& [nodes, share] : shares) {
    const double rest_m = norm(solid.points_m[static_cast<std::size_t>(nodes[1])] -
                               solid.points_m[static_cast<std::size_t>(nodes[0])]);
    lengths_.push_back({nodes, rest_m, constants.shearModulus_Pa * share / (rest_m * rest_m)});
  }
  const SolidMesh cells = tetrahedra(solid);
  const std::vector<double> volumes_m3 = tetrahedronVolumes(cells, solid.points_m);
  for (std::size_t c = 0; c < cells.cells(); ++c) {
    const std::span<const int> cell = cells.cell(c);
    volumes_.push_back(
        {{cell[0], cell[1], cell[2], cell[3]}, volumes_m3[c], constants.lame_Pa() / volumes_m3[c]});
  }
}

SpringLattice SpringLattice::calibrated(std::span<const Vec3> places_m, double energy_J) const {
  const double held_J = elasticEnergy_J(*this, places_m);
  constexpr double kRounding = 1e-12;
  if (!(energy_J > 0.0) || !(held_J > kRounding * energy_J)) {
    refuseParameter(Text::tr("Springs are calibrated by a displacement that holds energy"),
                    Text::tr("calibration"), Text::tr("Give a torque that is not 0"));
  }
  return scaled(energy_J / held_J);
}

SpringLattice SpringLattice::scaled(double factor) const {
  TORSIO_EXPECTS(factor > 0.0);
  SpringLattice result = *this;
  for (LengthSpring& spring : result.lengths_) {
    spring.stiffness_N_per_m *= factor;
  }
  for (VolumeSpring& spring : result.volumes_) {
    spring.stiffness_J_per_m6 *= factor;
  }
  return result;
}

std::span<const int> SpringLattice::elementNodes(std::size_t element) const noexcept {
  if (element < lengths_.size()) {
    return lengths_[element].nodes;
  }
  return volumes_[element - lengths_.size()].nodes;
}

bool SpringLattice::elementForces(std::size_t element, std::span<const Vec3> places_m, double& energy_J,
                                  std::span<Vec3> forces_N) const {
  if (element < lengths_.size()) {
    const LengthSpring& spring = lengths_[element];
    const Vec3 way = places_m[static_cast<std::size_t>(spring.nodes[1])] -
                     places_m[static_cast<std::size_t>(spring.nodes[0])];
    const double length_m = norm(way);
    const double stretch_m = length_m - spring.rest_m;
    energy_J = 0.5 * spring.stiffness_N_per_m * stretch_m * stretch_m;
    forces_N[1] = (spring.stiffness_N_per_m * stretch_m / length_m) * way;
    forces_N[0] = -forces_N[1];
    return length_m > 0.0;
  }
  const VolumeSpring& spring = volumes_[element - lengths_.size()];
  const VolumeGradient now = volumeGradient(cornersOf(spring, places_m));
  const double excess_m3 = now.volume_m3 - spring.rest_m3;
  energy_J = 0.5 * spring.stiffness_J_per_m6 * excess_m3 * excess_m3;
  for (std::size_t k = 0; k < 4; ++k) {
    forces_N[k] = spring.stiffness_J_per_m6 * excess_m3 * now.byPlace[k];
  }
  return true;
}

void SpringLattice::elementStiffness(std::size_t element, std::span<const Vec3> places_m,
                                     std::span<double> stiffness) const {
  if (element < lengths_.size()) {
    const LengthSpring& spring = lengths_[element];
    const Vec3 way = places_m[static_cast<std::size_t>(spring.nodes[1])] -
                     places_m[static_cast<std::size_t>(spring.nodes[0])];
    const double length_m = norm(way);
    const Eigen::Matrix3d along = outerProduct(way, way) / (length_m * length_m);
    const double across = 1.0 - spring.rest_m / length_m;
    const Eigen::Matrix3d block =
        spring.stiffness_N_per_m * (across * (Eigen::Matrix3d::Identity() - along) + along);
    Eigen::Map<Eigen::Matrix<double, 6, 6>> k(stiffness.data());
    k << block, -block, -block, block;
    return;
  }
  const VolumeSpring& spring = volumes_[element - lengths_.size()];
  const std::array<Vec3, 4> corners = cornersOf(spring, places_m);
  const VolumeGradient now = volumeGradient(corners);
  const double pull = spring.stiffness_J_per_m6 * (now.volume_m3 - spring.rest_m3) / 6.0;
  const std::array<Vec3, 3> edges{corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0]};
  Eigen::Map<Eigen::Matrix<double, 12, 12>> k(stiffness.data());
  // 6 V = a . (b x c): the second derivative by a and b is -[c x], and so on in turn; corner 0 moves all
  // three the other way.
  Eigen::Matrix<double, 9, 9> second = Eigen::Matrix<double, 9, 9>::Zero();
  second.block<3, 3>(0, 3) = -crossProductMatrix(edges[2]);
  second.block<3, 3>(3, 6) = -crossProductMatrix(edges[0]);
  second.block<3, 3>(0, 6) = crossProductMatrix(edges[1]);
  second.block<3, 3>(3, 0) = second.block<3, 3>(0, 3).transpose();
  second.block<3, 3>(6, 3) = second.block<3, 3>(3, 6).transpose();
  second.block<3, 3>(6, 0) = second.block<3, 3>(0, 6).transpose();
  Eigen::Matrix<double, 9, 12> toEdges = Eigen::Matrix<double, 9, 12>::Zero();
  for (int e = 0; e < 3; ++e) {
    toEdges.block<3, 3>(3 * e, 3 * (e + 1)).setIdentity();
    toEdges.block<3, 3>(3 * e, 0) = -Eigen::Matrix3d::Identity();
  }
  k = pull * toEdges.transpose() * second * toEdges;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      k.block<3, 3>(3 * a, 3 * b) +=
          spring.stiffness_J_per_m6 *
          outerProduct(now.byPlace[static_cast<std::size_t>(a)], now.byPlace[static_cast<std::size_t>(b)]);
    }
  }
}

double elasticEnergy_J(const ElasticBody& body, std::span<const Vec3> places_m) {
  std::array<Vec3, kMaxElementNodes> forces;
  double sum_J = 0.0;
  for (std::size_t e = 0; e < body.elements(); ++e) {
    double energy_J = 0.0;
    const bool sound =
        body.elementForces(e, places_m, energy_J, std::span(forces).first(body.elementNodes(e).size()));
    TORSIO_EXPECTS(sound);
    sum_J += energy_J;
  }
  return sum_J;
}

namespace {

constexpr double kSmallTurn_rad = 0.01;  ///< of the free end: springs are calibrated where they are linear

/// Every section turned in its plane as the membrane analogy says when the free end turns by kSmallTurn_rad.
std::vector<Vec3> sectionsTurned(const SweptSolid& solid, const SectionLattice& lattice,
                                 const TwistModel& model) {
  const TwistState state =
      model.stateForTorque(lattice.length_m(), kSmallTurn_rad / model.graspCompliance(lattice.length_m()));
  std::vector<Vec3> turned = solid.points_m;
  for (int j = 0; j < solid.sections; ++j) {
    const double arc_m = lattice.sectionArc_m(j);
    const AxisFrame frame = lattice.frameAt(arc_m);
    const SinCos turn = portableSinCos(model.angleAt(arc_m, state));
    for (int i = 0; i < solid.pointsPerSection(); ++i) {
      Vec3& place = turned[static_cast<std::size_t>(j) * static_cast<std::size_t>(solid.pointsPerSection()) +
                           static_cast<std::size_t>(i)];
      const Vec3 arm = place - frame.centre_m;
      const Vec3 along = dot(arm, frame.tangent) * frame.tangent;
      place = frame.centre_m + along + turn.cos * (arm - along) + turn.sin * cross(frame.tangent, arm);
    }
  }
  return turned;
}

}  // namespace

SpringLattice calibratedSprings(const SweptSolid& solid, const SectionLattice& lattice,
                                const ElasticConstants& constants, const TwistModel& model,
                                Calibration calibration, const std::function<void()>& check) {
  const double compliance = model.graspCompliance(lattice.length_m());
  const double energy_J = 0.5 * kSmallTurn_rad * kSmallTurn_rad / compliance;
  SpringLattice springs =
      SpringLattice(solid, constants).calibrated(sectionsTurned(solid, lattice, model), energy_J);
  if (calibration == Calibration::kAffine) {
    return springs;
  }
  Equilibrium newton(springs, twistEnds(solid), solid.points_m, check);
  TwistPose pose{solid.points_m};
  static_cast<void>(newton.solve(kSmallTurn_rad / compliance, pose));
  return springs.scaled(pose.angle_rad / kSmallTurn_rad);
}

XpbdFrames::XpbdFrames(const SweptSolid& solid, TwistEnds ends, SpringLattice springs,
                       const DynamicsOptions& options, int substeps)
    : ends_(std::move(ends)),
      options_(options),
      rest_m_(solid.points_m),
      springs_(std::move(springs)),
      substeps_(substeps),
      inverseMass_(nodeMasses(tetrahedra(solid), solid.points_m, options.density_kg_per_m3)),
      turned_(solid.points_m.size(), 0),
      inverseInertia_(1.0 / endInertia(ends_, solid.points_m, inverseMass_)),
      velocity_(solid.points_m.size()),
      before_m_(solid.points_m.size()),
      pose_{solid.points_m} {
  if (substeps < 1) {
    refuseParameter(Text::tr("A frame needs at least 1 substep"), Text::tr("substeps"),
                    Text::tr("Give 10 or more"));
  }
  double turned_kg = 0.0;
  for (const int node : ends_.turned) {
    turned_kg += inverseMass_[static_cast<std::size_t>(node)];
  }
  inverseTurnedMass_ = ends_.placeFree ? 1.0 / turned_kg : 0.0;
  for (double& m : inverseMass_) {
    m = m > 0.0 ? 1.0 / m : 0.0;
  }
  for (const int node : ends_.held) {
    inverseMass_[static_cast<std::size_t>(node)] = 0.0;
  }
  for (const int node : ends_.turned) {
    inverseMass_[static_cast<std::size_t>(node)] = 0.0;
    turned_[static_cast<std::size_t>(node)] = 1;
  }
}

Vec3 XpbdFrames::endPlace(std::size_t node) const noexcept {
  const Vec3 arm = rest_m_[node] - ends_.axisPoint_m;
  const Vec3 along = dot(arm, ends_.axis) * ends_.axis;
  return ends_.axisPoint_m + pose_.way_m + along + cosine_ * (arm - along) + sine_ * cross(ends_.axis, arm);
}

void XpbdFrames::project(std::span<const int> nodes, std::span<const Vec3> gradients, double excess,
                         double inverseStiffness_per_s2) {
  double weight = inverseStiffness_per_s2;
  double byAngle = 0.0;
  Vec3 byWay;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto i = static_cast<std::size_t>(nodes[k]);
    weight += inverseMass_[i] * dot(gradients[k], gradients[k]);
    if (turned_[i] != 0) {
      byAngle += dot(gradients[k], turningOf(ends_, pose_, nodes[k]));
      byWay += gradients[k];
    }
  }
  weight += inverseInertia_ * byAngle * byAngle + inverseTurnedMass_ * dot(byWay, byWay);
  const double multiplier = -excess / weight;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto i = static_cast<std::size_t>(nodes[k]);
    pose_.places_m[i] += (multiplier * inverseMass_[i]) * gradients[k];
  }
  pose_.way_m += (multiplier * inverseTurnedMass_) * byWay;
  if (byAngle != 0.0) {
    angle_rad_ += multiplier * inverseInertia_ * byAngle;
    const SinCos turn = portableSinCos(angle_rad_);
    cosine_ = turn.cos;
    sine_ = turn.sin;
  }
}

void XpbdFrames::substep(double torque_Nm, double time_s) {
  const double kept = 1.0 / (1.0 + options_.drag_per_s * time_s);
  before_m_ = pose_.places_m;
  const double angleBefore_rad = angle_rad_;
  const Vec3 wayBefore_m = pose_.way_m;
  for (std::size_t i = 0; i < rest_m_.size(); ++i) {
    pose_.places_m[i] += (time_s * kept) * velocity_[i];
  }
  spin_rad_per_s_ = kept * (spin_rad_per_s_ + time_s * inverseInertia_ * torque_Nm);
  angle_rad_ += time_s * spin_rad_per_s_;
  pose_.way_m += (time_s * kept) * turnedVelocity_;
  const SinCos turn = portableSinCos(angle_rad_);
  cosine_ = turn.cos;
  sine_ = turn.sin;
  const auto follow = [this](int node) {
    const auto i = static_cast<std::size_t>(node);
    if (turned_[i] != 0) {
      pose_.places_m[i] = endPlace(i);
    }
  };
  const double perTime2 = 1.0 / (time_s * time_s);
  for (const LengthSpring& spring : springs_.lengthSprings()) {
    follow(spring.nodes[0]);
    follow(spring.nodes[1]);
    const Vec3 way = pose_.places_m[static_cast<std::size_t>(spring.nodes[1])] -
                     pose_.places_m[static_cast<std::size_t>(spring.nodes[0])];
    const double length_m = norm(way);
    const Vec3 along = length_m > 0.0 ? way / length_m : Vec3{};
    const std::array<Vec3, 2> gradients{-along, along};
    project(spring.nodes, gradients, length_m - spring.rest_m, perTime2 / spring.stiffness_N_per_m);
  }
  for (const VolumeSpring& spring : springs_.volumeSprings()) {
    std::array<Vec3, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) {
      follow(spring.nodes[k]);
      corners[k] = pose_.places_m[static_cast<std::size_t>(spring.nodes[k])];
    }
    const VolumeGradient now = volumeGradient(corners);
    project(spring.nodes, now.byPlace, now.volume_m3 - spring.rest_m3, perTime2 / spring.stiffness_J_per_m6);
  }
  for (const int node : ends_.turned) {
    follow(node);
  }
  for (std::size_t i = 0; i < rest_m_.size(); ++i) {
    velocity_[i] = inverseMass_[i] > 0.0 ? (pose_.places_m[i] - before_m_[i]) / time_s : Vec3{};
  }
  spin_rad_per_s_ = (angle_rad_ - angleBefore_rad) / time_s;
  turnedVelocity_ = (pose_.way_m - wayBefore_m) / time_s;
  pose_.angle_rad = angle_rad_;
}

void XpbdFrames::stepTo(double angle_rad) {
  const double time_s = options_.frame_s / substeps_;
  const double kept = 1.0 / (1.0 + options_.drag_per_s * time_s);
  const double turn_rad = (angle_rad - angle_rad_) / substeps_;
  const double inverseInertia = std::exchange(inverseInertia_, 0.0);  // springs do not move what is led
  for (int i = 0; i < substeps_; ++i) {
    spin_rad_per_s_ = turn_rad / (time_s * kept);
    substep(0.0, time_s);
  }
  inverseInertia_ = inverseInertia;
}

void XpbdFrames::step(double torque_Nm) {
  for (int i = 0; i < substeps_; ++i) {
    substep(torque_Nm, options_.frame_s / substeps_);
  }
}

}  // namespace torsio
