// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/landmark_turn.h"

#include "sim/core/pose.h"

namespace torsio {
namespace {

/// Direction of the line and the part of the point's place that is perpendicular to it.
struct LineAndArm {
  Vec3 axis;
  Vec3 arm;
};

LineAndArm lineAndArm(const Landmarks& marks) noexcept {
  const Vec3 axis = normalized(marks.to - marks.from);
  const Vec3 arm = marks.point - marks.from;
  return {.axis = axis, .arm = arm - dot(arm, axis) * axis};
}

}  // namespace

double landmarkTurn_rad(const Landmarks& rest, const Landmarks& now, double before_rad) noexcept {
  const LineAndArm was = lineAndArm(rest);
  const LineAndArm is = lineAndArm(now);
  const double along = 1.0 + dot(was.axis, is.axis);
  if (!(along > 1e-9)) {
    return before_rad;
  }
  const Vec3 half = cross(was.axis, is.axis);
  const Vec3 carried = rotate(normalized(Quat{along, half.x, half.y, half.z}), was.arm);
  const double sine = dot(is.axis, cross(carried, is.arm));
  const double cosine = dot(carried, is.arm);
  const bool measurable = sine * sine + cosine * cosine > 0.0;
  return measurable ? unwrapNear(portableAtan2(sine, cosine), before_rad) : before_rad;
}

}  // namespace torsio
