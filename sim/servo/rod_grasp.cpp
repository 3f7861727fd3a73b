// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/rod_grasp.h"

#include <cmath>

#include "sim/core/pose.h"

namespace torsio {

namespace {

// A soft swing of the whole organ pulls at each node with less than the usual millinewton that is let stand.
constexpr RodStepRules kRules{.settledForce_N = 3e-5, .settledMoment_Nm = 1e-6};

}  // namespace

void RodGrasp::close(const RodOrgan& organ, double arc_m, const Pose& tool, OrganState& state) noexcept {
  if (state.pose.count == 0) {
    state.pose = organ.rod().rest();
  }
  closed_ = tool;
  grip_ = organ.grip(state.pose, arc_m, tool);
  state.twist.graspArc_m = arc_m;
  load_ = {};
  torque_Nm_ = 0.0;
  look(organ, state);
}

void RodGrasp::look(const RodOrgan& organ, OrganState& state) noexcept {
  const RodCurve curve = organ.skin().curveOf(state.pose);
  state.twist.graspAngle_rad = organ.turn_rad(grip_, state.pose, curve, state.twist.graspAngle_rad);
  folds_ = organ.skin().sharpestBend(curve) > kFoldingBend;
  if (const auto counted_rad = organ.slippedBack_rad(grip_, state.pose, state.twist.graspAngle_rad)) {
    state.twist.graspAngle_rad = *counted_rad;
    folds_ = true;
  }
}

void RodGrasp::follow(const RodOrgan& organ, const Pose& tool, double turn_rad, TwistDrive drive,
                      double duration_s, OrganState& state) noexcept {
  Pose hand = organ.handAfter(grip_, closed_, tool, turn_rad);
  const bool carried = drive == TwistDrive::kRoll && organ.task().axis == GripAxis::kLine;
  if (carried) {  // the stylus only rolls: its roll carries the grip round the line
    const Vec3& centre_m = grip_.axis.centre_m;
    hand.position_m = centre_m + rotateAbout(tool.position_m - centre_m, grip_.axis.tangent, turn_rad);
  }
  const RodStepResult result = stepRod(organ.rod(), &grip_.jaw, hand, duration_s, state.pose, work_, kRules);
  load_ = result.load;
  torque_Nm_ = result.status == RodStepStatus::kHandLost ? 0.0 : RodOrgan::torque_Nm(grip_, load_, hand);
  if (carried) {
    load_.force_N = rotateAbout(load_.force_N, grip_.axis.tangent, -turn_rad);
  }
  look(organ, state);
}

RodReturn RodGrasp::relax(const RodOrgan& organ, double duration_s, OrganState& state) noexcept {
  const RodStepResult result = stepRod(organ.rod(), nullptr, {}, duration_s, state.pose, work_, kRules);
  load_ = {};
  torque_Nm_ = 0.0;
  look(organ, state);
  const bool back = std::abs(state.twist.graspAngle_rad) < kRestTurn_rad &&
                    organ.farthestFromRest_m(state.pose) < kRestWay_m;
  if (back) {
    state = {};
    return RodReturn::kRest;
  }
  const bool still = result.status == RodStepStatus::kAtRest || result.status == RodStepStatus::kKept;
  return still ? RodReturn::kStays : RodReturn::kMoving;
}

Vec3 RodGrasp::force_N(const RodOrgan& organ, const Vec3& tip_m) const noexcept {
  const AxisFrame& axis = grip_.axis;
  const Vec3 way = tip_m - axis.centre_m;
  const Vec3 arm = way - dot(way, axis.tangent) * axis.tangent;
  const double nearest2_m2 = organ.turnStiffness_Nm_per_rad() / kStiffnessCap_N_per_m;
  const double arm2_m2 = dot(arm, arm);
  const double divisor_m2 = arm2_m2 > nearest2_m2 ? arm2_m2 : nearest2_m2;
  if (!(divisor_m2 > 0.0)) {
    return load_.force_N;
  }
  return load_.force_N + cross(axis.tangent, arm) * (dot(load_.torque_Nm, axis.tangent) / divisor_m2);
}

bool RodGrasp::drawnBeyond(double way_m) const noexcept {
  const double most_N = grip_.jaw.stiffness.place_N_per_m * way_m;
  return dot(load_.force_N, load_.force_N) > most_N * most_N;
}

}  // namespace torsio
