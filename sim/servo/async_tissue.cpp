// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/async_tissue.h"

#include <algorithm>

namespace torsio {

namespace {

constexpr double kNoArm_m = 1e-6;

}  // namespace

void AsyncTissue::grip() noexcept {
  last_ = {};
  silent_us_ = 0;
}

void AsyncTissue::hear(const BesideAnswer& answer, std::int64_t tickPeriod_us) noexcept {
  if (answer.state == BesideState::kNothing) {
    silent_us_ += tickPeriod_us;
    return;
  }
  last_ = answer;
  silent_us_ = 0;
}

bool AsyncTissue::doubtful() const noexcept {
  return last_.state == BesideState::kBroken || silent_us_ > kBesideLate_us;
}

double AsyncTissue::torque_Nm(double angle_rad) const noexcept {
  if (last_.state != BesideState::kSound || doubtful()) {
    return 0.0;
  }
  const double beyond_rad = std::clamp(angle_rad - last_.angle_rad, -kBesideReach_rad, kBesideReach_rad);
  return last_.torque_Nm + last_.slope_Nm_per_rad * beyond_rad;
}

Vec3 AsyncTissue::force_N(double angle_rad, const AxisFrame& axis, const Vec3& tip_m,
                          double stiffnessCap_N_per_m) const noexcept {
  const Vec3 way = cross(axis.tangent, tip_m - axis.centre_m);  // of the tip for one radian
  const double arm2_m2 = dot(way, way);
  if (!(arm2_m2 > kNoArm_m * kNoArm_m)) {
    return {};
  }
  const double nearest2_m2 = std::max(0.0, last_.slope_Nm_per_rad) / stiffnessCap_N_per_m;
  return (-torque_Nm(angle_rad) / std::max(arm2_m2, nearest2_m2)) * way;
}

}  // namespace torsio
