// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/reference_solid.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "sim/core/angle.h"
#include "sim/core/portable_math.h"

namespace torsio {

ReferenceSolid::ReferenceSolid(SweptSolid solid, const ElasticConstants& constants, const TwistHold& hold,
                               std::function<void()> check, ReferenceElements elements)
    : solid_(std::move(solid)),
      ends_(twistEnds(solid_, hold)),
      body_(meshOf(elements), solid_.points_m, constants),
      newton_(body_, ends_, solid_.points_m, std::move(check)),
      pose_{solid_.points_m} {}

SolidMesh ReferenceSolid::meshOf(ReferenceElements elements) const {
  if (elements == ReferenceElements::kTetrahedra) {
    return quadraticTetrahedra(solid_);
  }
  const bool even = solid_.ridges % 2 == 0 && solid_.rings % 2 == 0 && solid_.sections % 2 == 1;
  return even ? quadraticWedges(solid_) : linearWedges(solid_);
}

void ReferenceSolid::toRest() {
  pose_ = {solid_.points_m};
  torque_Nm_ = 0.0;
  energy_J_ = 0.0;
}

void ReferenceSolid::load(double torque_Nm) {
  if (torque_Nm == torque_Nm_) {
    return;
  }
  if (torque_Nm_ == 0.0) {
    torque_Nm_ = kFirstShare * torque_Nm;
    energy_J_ = newton_.solve(torque_Nm_, pose_).energy_J;
  }
  pose_ = turnedOn(solid_, ends_, pose_, torque_Nm / torque_Nm_);
  energy_J_ = newton_.solve(torque_Nm, pose_).energy_J;
  torque_Nm_ = torque_Nm;
}

void ReferenceSolid::stepTo(double angle_rad) {
  pose_ = turnedOn(solid_, ends_, pose_, angle_rad / pose_.angle_rad);
  const EquilibriumReport report = newton_.keepAngle(pose_);
  energy_J_ = report.energy_J;
  torque_Nm_ = report.torque_Nm;
}

void ReferenceSolid::turnTo(double angle_rad) {
  constexpr double kLongestStep_rad = radians(10.0);
  if (angle_rad == 0.0) {
    toRest();
    return;
  }
  if (pose_.angle_rad == 0.0) {
    turnEnd(ends_, solid_.points_m, kFirstShare * angle_rad, pose_);
    stepTo(pose_.angle_rad);
  }
  const double start_rad = pose_.angle_rad;
  const double way_rad = angle_rad - start_rad;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(way_rad) / kLongestStep_rad - 1e-2)));
  for (int k = 1; k <= steps; ++k) {
    stepTo(k == steps ? angle_rad : start_rad + way_rad * k / steps);
  }
}

namespace {

Eigen::Vector3d toEigen(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Vec3 meanOf(std::span<const Vec3> places) {
  Vec3 sum;
  for (const Vec3& p : places) {
    sum += p;
  }
  return sum / static_cast<double>(places.size());
}

/// Rotation vector that turns one set of arms into the other best (least squares).
Eigen::Vector3d bestTurn(std::span<const Vec3> rest, std::span<const Vec3> now, const Vec3& restCentre,
                         const Vec3& centre) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < rest.size(); ++i) {
    covariance += toEigen(now[i] - centre) * toEigen(rest[i] - restCentre).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::AngleAxisd turn(
      Eigen::Matrix3d(svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose()));
  return turn.angle() * turn.axis();
}

/// The same rotation, whole turns more or less, nearest to another.
Eigen::Vector3d unwrapped(const Eigen::Vector3d& turn, const Eigen::Vector3d& near) {
  const double angle = turn.norm();
  if (angle < 1e-12) {
    return turn;
  }
  const Eigen::Vector3d axis = turn / angle;
  const double turns = std::round((near.dot(axis) - angle) / (2.0 * kPi));
  return (angle + 2.0 * kPi * turns) * axis;
}

}  // namespace

std::vector<double> sectionTurns_rad(const SweptSolid& solid, std::span<const Vec3> places_m) {
  std::vector<double> turns;
  const auto count = static_cast<std::size_t>(solid.ridges);
  for (int j = 0; j < solid.sections; ++j) {
    // The outline only: of the points inside, quadratic elements leave some where they were.
    const auto first = static_cast<std::size_t>(solid.point(j, solid.rings, 0));
    const std::span<const Vec3> rest = std::span(solid.points_m).subspan(first, count);
    const std::span<const Vec3> now = places_m.subspan(first, count);
    const Eigen::Vector3d turn = bestTurn(rest, now, meanOf(rest), meanOf(now));
    const double angle = turn.norm();
    const double along = angle > 0.0 ? turn.dot(toEigen(sectionTangent(solid, j))) / angle : 0.0;
    const double swung = 2.0 * std::atan2(std::sin(0.5 * angle) * along, std::cos(0.5 * angle));
    turns.push_back(unwrapNear(swung, turns.empty() ? 0.0 : turns.back()));
  }
  return turns;
}

TwistPose turnedOn(const SweptSolid& solid, const TwistEnds& ends, const TwistPose& pose, double ratio) {
  TwistPose result = pose;
  const auto count = static_cast<std::size_t>(solid.pointsPerSection());
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (std::size_t j = 0; j < static_cast<std::size_t>(solid.sections); ++j) {
    const std::span<const Vec3> rest = std::span(solid.points_m).subspan(j * count, count);
    const std::span<const Vec3> now = std::span(pose.places_m).subspan(j * count, count);
    const Vec3 centre = now[0];
    const auto ridges = static_cast<std::size_t>(solid.ridges);
    last = unwrapped(bestTurn(rest.last(ridges), now.last(ridges), rest[0], centre), last);
    const Eigen::Vector3d more = (ratio - 1.0) * last;
    const double angle = more.norm();
    const Eigen::Matrix3d turn = angle > 0.0 ? Eigen::AngleAxisd(angle, more / angle).toRotationMatrix()
                                             : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    const Vec3 moved = rest[0] + ratio * (centre - rest[0]);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d arm = turn * toEigen(now[i] - centre);
      result.places_m[j * count + i] = moved + Vec3{arm.x(), arm.y(), arm.z()};
    }
  }
  result.way_m = ratio * pose.way_m;
  turnEnd(ends, solid.points_m, ratio * pose.angle_rad, result);
  return result;
}

}  // namespace torsio
