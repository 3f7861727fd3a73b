// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/grasp.h"

#include "sim/core/portable_math.h"

namespace torsio {

namespace {

struct Cylindrical {
  double height_m = 0.0;
  double radius_m = 0.0;
  Vec3 outwards;
};

Cylindrical about(const AxisFrame& axis, const Vec3& point_m) noexcept {
  const Vec3 way = point_m - axis.centre_m;
  Cylindrical c;
  c.height_m = dot(way, axis.tangent);
  const Vec3 across = way - axis.tangent * c.height_m;
  c.radius_m = norm(across);
  c.outwards = normalized(across);
  return c;
}

}  // namespace

double radiusAbout_m(const AxisFrame& axis, const Vec3& point_m) noexcept {
  return about(axis, point_m).radius_m;
}

void JawMotion::close(const AxisFrame& axis, const ToolState& tool, double organ_rad) noexcept {
  axis_ = axis;
  organFrom_rad_ = organ_rad;
  tipFrom_rad_ = tipAngle(tool);
  orientationFrom_ = tool.pose.orientation;
  const Cylindrical at = about(axis_, tool.pose.position_m);
  radiusFrom_m_ = at.radius_m;
  heightFrom_m_ = at.height_m;
  angle_rad_ = 0.0;
  angle_rad_ = driveAngle(tool);
  restart();
}

double JawMotion::tipAngle(const ToolState& tool) const noexcept {
  const Vec3 way = tool.pose.position_m - axis_.centre_m;
  return portableAtan2(dot(way, axis_.e2), dot(way, axis_.e1));
}

double JawMotion::driveAngle(const ToolState& tool) const noexcept {
  if (drive_ == TwistDrive::kRoll) {
    return unwrapNear(turnAbout(axis_.tangent, orientationFrom_, tool.pose.orientation), angle_rad_);
  }
  const Vec3 way = tool.pose.position_m - axis_.centre_m;
  const double x = dot(way, axis_.e1);
  const double y = dot(way, axis_.e2);
  if (!(x * x + y * y >= kNearAxis_m * kNearAxis_m)) {
    return angle_rad_;  // also of a place that is not finite
  }
  return unwrapNear(tipAngle(tool), angle_rad_);
}

Vec3 JawMotion::drift_m(const ToolState& tool) const noexcept {
  const Cylindrical at = about(axis_, tool.pose.position_m);
  return at.outwards * (at.radius_m - radiusFrom_m_) + axis_.tangent * (at.height_m - heightFrom_m_);
}

ToolState JawMotion::carried(const ToolState& tool, double organ_rad) const noexcept {
  const double alone_rad = tipAngle(tool) - tipFrom_rad_;
  const double turn_rad = organ_rad - organFrom_rad_ - alone_rad;
  ToolState carried = tool;
  carried.pose.position_m =
      axis_.centre_m + rotateAbout(tool.pose.position_m - axis_.centre_m, axis_.tangent, turn_rad);
  return carried;
}

}  // namespace torsio
