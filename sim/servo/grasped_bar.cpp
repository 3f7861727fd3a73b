// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/grasped_bar.h"

#include <algorithm>
#include <cmath>

#include "sim/core/portable_math.h"

namespace torsio {

namespace {

// Least share of the model's turn that the gripped section must follow; at a held end it follows none.
constexpr double kLeastShare = 0.1;

}  // namespace

GraspedBar::GraspedBar(const Scene& scene, std::int64_t tickPeriod_us)
    : model_(&scene.model),
      returnFactor_(portableExp(-static_cast<double>(tickPeriod_us) * 1e-6 / kReturnTime_s)) {}

std::optional<AxisFrame> GraspedBar::grip(const Vec3& held_m, double arc_m, const ToolState& /*tool*/,
                                          OrganState& organ) noexcept {
  const AxisFrame axis = model_->graspFrame(arc_m);
  if (!(model_->angleAt(arc_m, {arc_m, 1.0}) > kLeastShare) || !(radiusAbout_m(axis, held_m) > kNearAxis_m)) {
    return std::nullopt;  // held there, or no arm: nothing to twist
  }
  organ.twist = {arc_m, 0.0};
  return axis;
}

std::uint32_t GraspedBar::follow(const ToolState& /*tool*/, JawMotion& motion, OrganState& organ) noexcept {
  organ.twist.graspAngle_rad = motion.turn_rad();
  return kEventNone;
}

TissueReturn GraspedBar::relax(OrganState& organ) noexcept {
  organ.twist.graspAngle_rad *= returnFactor_;
  if (std::abs(organ.twist.graspAngle_rad) > kAtRest_rad) {
    return TissueReturn::kMoving;
  }
  organ = {};
  return TissueReturn::kReturned;
}

GripFeel GraspedBar::feel(const Vec3& tip_m, const JawMotion& /*motion*/,
                          const OrganState& organ) const noexcept {
  return {model_->torque_Nm(organ.twist), model_->graspForce_N(organ.twist, tip_m)};
}

void GraspedAsync::takeAnswer(const AsyncAnswer& answer) noexcept {
  if (answer.state == AsyncState::kNothing) {
    silent_us_ += tickPeriod_us_;
    return;
  }
  last_ = answer;
  silent_us_ = 0;
}

std::optional<AxisFrame> GraspedAsync::grip(const Vec3& held_m, double arc_m, const ToolState& tool,
                                            OrganState& organ) noexcept {
  const std::optional<AxisFrame> axis = GraspedBar::grip(held_m, arc_m, tool, organ);
  if (axis) {
    last_ = {};
    silent_us_ = 0;
  }
  return axis;
}

GripFeel GraspedAsync::feel(const Vec3& tip_m, const JawMotion& motion,
                            const OrganState& organ) const noexcept {
  GripFeel felt;
  felt.late = last_.state == AsyncState::kBroken || silent_us_ > kAsyncLate_us;
  if (felt.late) {
    return felt;
  }
  if (last_.state == AsyncState::kSound) {
    const double beyond_rad =
        std::clamp(organ.twist.graspAngle_rad - last_.angle_rad, -kAsyncReach_rad, kAsyncReach_rad);
    felt.torque_Nm = last_.torque_Nm + last_.slope_Nm_per_rad * beyond_rad;
  }
  constexpr double kNoArm_m = 1e-6;
  const Vec3 way = cross(motion.axis().tangent, tip_m - motion.axis().centre_m);  // of the tip, a radian
  const double arm2_m2 = dot(way, way);
  if (arm2_m2 > kNoArm_m * kNoArm_m) {
    const double nearest2_m2 = std::max(0.0, last_.slope_Nm_per_rad) / model().options().stiffnessCap_N_per_m;
    felt.force_N = (-felt.torque_Nm / std::max(arm2_m2, nearest2_m2)) * way;
  }
  return felt;
}

}  // namespace torsio
