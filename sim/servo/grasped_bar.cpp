// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/grasped_bar.h"

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

}  // namespace torsio
