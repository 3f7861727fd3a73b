// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/xpbd_frames.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"

namespace torsio {

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
