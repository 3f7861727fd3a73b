// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/grasp_share.h"

#include <cmath>

#include "sim/servo/exercise.h"

namespace torsio {

namespace {

// Turn with which a grip is tried out.
constexpr double kProbe_rad = 1e-4;
// The probe is exact to about 1e-9: a share this near to one is one.
constexpr double kRounding = 1e-6;

}  // namespace

double graspShare(const TwistModel& model, const AxisFrame& axis, double arc_m, const Vec3& rest_m) noexcept {
  const Vec3 forward = cross(axis.tangent, rest_m - axis.centre_m);
  const double radius_m = norm(forward);
  if (!(radius_m > kNearAxis_m)) {
    return 0.0;
  }
  const Vec3 more = model.toDeformed_m(rest_m, {arc_m, kProbe_rad});
  const Vec3 less = model.toDeformed_m(rest_m, {arc_m, -kProbe_rad});
  const double share = dot(more - less, forward) / (2.0 * kProbe_rad * radius_m * radius_m);
  return std::abs(share - 1.0) < kRounding ? 1.0 : share;
}

}  // namespace torsio
