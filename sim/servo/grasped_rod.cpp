// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/grasped_rod.h"

#include <cmath>

#include "sim/core/pose.h"

namespace torsio {

namespace {

// A soft swing of the whole organ pulls at each node with less than the usual millinewton that is let stand.
constexpr RodStepRules kRules{.settledForce_N = 3e-5, .settledMoment_Nm = 1e-6};

}  // namespace

std::optional<AxisFrame> GraspedRod::grip(const Vec3& /*held_m*/, double arc_m, const ToolState& tool,
                                          OrganState& organ) noexcept {
  if (organ.pose.count == 0) {
    organ.pose = rod_->rod().rest();
  }
  closed_ = tool.pose;
  grip_ = rod_->grip(organ.pose, arc_m, tool.pose);
  organ.twist.graspArc_m = arc_m;
  load_ = {};
  torque_Nm_ = 0.0;
  look(organ);
  return grip_.axis;
}

void GraspedRod::look(OrganState& organ) noexcept {
  const RodCurve curve = rod_->skin().curveOf(organ.pose);
  organ.twist.graspAngle_rad = rod_->turn_rad(grip_, organ.pose, curve, organ.twist.graspAngle_rad);
  folds_ = rod_->skin().sharpestBend(curve) > kFoldingBend;
  if (const auto counted_rad = rod_->slippedBack_rad(grip_, organ.pose, organ.twist.graspAngle_rad)) {
    organ.twist.graspAngle_rad = *counted_rad;
    folds_ = true;
  }
}

std::uint32_t GraspedRod::follow(const ToolState& tool, JawMotion& motion, OrganState& organ) noexcept {
  const double turn_rad = motion.turn_rad();
  Pose hand = rod_->handAfter(grip_, closed_, tool.pose, turn_rad);
  const bool rolled = motion.drive() == TwistDrive::kRoll && rod_->task().axis == GripAxis::kLine;
  if (rolled) {  // the stylus only rolls: its roll carries the grip round the line
    const Vec3& centre_m = grip_.axis.centre_m;
    hand.position_m = centre_m + rotateAbout(tool.pose.position_m - centre_m, grip_.axis.tangent, turn_rad);
  }
  const RodStepResult result = stepRod(rod_->rod(), &grip_.jaw, hand, tick_s_, organ.pose, work_, kRules);
  load_ = result.load;
  torque_Nm_ = result.status == RodStepStatus::kHandLost ? 0.0 : RodOrgan::torque_Nm(grip_, load_, hand);
  if (rolled) {
    load_.force_N = rotateAbout(load_.force_N, grip_.axis.tangent, -turn_rad);
  }
  look(organ);
  if (folds_) {
    return kEventFolded;
  }
  const double most_N = grip_.jaw.stiffness.place_N_per_m * kSlipWay_m;
  return dot(load_.force_N, load_.force_N) > most_N * most_N ? kEventSlipped : kEventNone;
}

TissueReturn GraspedRod::relax(OrganState& organ) noexcept {
  const RodStepResult result = stepRod(rod_->rod(), nullptr, {}, tick_s_, organ.pose, work_, kRules);
  load_ = {};
  torque_Nm_ = 0.0;
  look(organ);
  if (std::abs(organ.twist.graspAngle_rad) < kRestTurn_rad &&
      rod_->farthestFromRest_m(organ.pose) < kRestWay_m) {
    organ = {};
    return TissueReturn::kReturned;
  }
  const bool still = result.status == RodStepStatus::kAtRest || result.status == RodStepStatus::kKept;
  return still ? TissueReturn::kReturned : TissueReturn::kMoving;  // in balance elsewhere: another rest
}

GripFeel GraspedRod::feel(const Vec3& tip_m, const JawMotion& /*motion*/,
                          const OrganState& /*organ*/) const noexcept {
  const AxisFrame& axis = grip_.axis;
  const Vec3 way = tip_m - axis.centre_m;
  const Vec3 arm = way - dot(way, axis.tangent) * axis.tangent;
  const double nearest2_m2 = rod_->turnStiffness_Nm_per_rad() / kStiffnessCap_N_per_m;
  const double arm2_m2 = dot(arm, arm);
  const double divisor_m2 = arm2_m2 > nearest2_m2 ? arm2_m2 : nearest2_m2;
  GripFeel felt{torque_Nm_, load_.force_N};
  if (divisor_m2 > 0.0) {
    felt.force_N =
        load_.force_N + cross(axis.tangent, arm) * (dot(load_.torque_Nm, axis.tangent) / divisor_m2);
  }
  return felt;
}

}  // namespace torsio
