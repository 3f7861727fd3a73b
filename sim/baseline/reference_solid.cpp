// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/reference_solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/angle.h"

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

}  // namespace torsio
