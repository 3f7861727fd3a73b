// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/detorsion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/random.h"

namespace torsio {

namespace {

constexpr std::array<FlowCheckCost, 4> kCosts{{{}, {1'000'000, 0.25}, {2'000'000, 0.2}, {5'000'000, 0.08}}};

/// A deviate of mean 0 and variance 1 that is nearly normal: twelve uniform ones less 6.
double deviate(std::uint64_t seed) noexcept {
  double sum = -6.0;
  for (std::uint64_t i = 0; i < 12; ++i) {
    sum += static_cast<double>(mixedBits(seed + i) >> 11U) * 0x1p-53;
  }
  return sum;
}

}  // namespace

FlowCheckCost flowCheckCost(FlowCheck check) noexcept {
  return kCosts[static_cast<std::size_t>(check)];
}

double DetorsionStep::relapse_Nm(const HollowOrgan& hollow, const OrganState& organ) noexcept {
  const BaseFriction& base = hollow.detorsion().base;
  const double start_rad = organ.hollow.start_rad;
  const double angle_rad = organ.twist.graspAngle_rad;
  const double beyond_rad = (start_rad < 0.0 ? -angle_rad : angle_rad) - base.relapseFrom_rad;
  if (!(beyond_rad > 0.0)) {
    return 0.0;
  }
  const double torque_Nm =
      base.relapseShare * hollow.basePeak_Nm() * std::min(beyond_rad / kRelapseRamp_rad, 1.0);
  return start_rad < 0.0 ? -torque_Nm : torque_Nm;
}

void DetorsionStep::setHolders(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept {
  HollowPose& pose = organ.hollow;
  const bool pressed = jaw.secondButton && !buttonDown_;
  buttonDown_ = jaw.secondButton;
  bool clipped = pose.clipped;
  if (holdAsked_ != Ask::kNothing) {
    clipped = holdAsked_ == Ask::kOn;
  } else if (pressed && (jaw.touches || jaw.holds)) {
    clipped = !clipped;
  }
  holdAsked_ = Ask::kNothing;
  if (clipped != pose.clipped) {
    events |= clipped ? kEventClipped : kEventUnclipped;
  }
  pose.clipped = clipped;
}

void DetorsionStep::step(const HollowOrgan& hollow, const JawState& jaw, OrganState& organ,
                         std::uint32_t& events) noexcept {
  HollowPose& pose = organ.hollow;
  if (jaw.holds || pose.clipped) {
    relapsing_ = false;
  } else {
    slip(hollow, organ, events);
  }
  const double angle_rad = organ.twist.graspAngle_rad;
  moveContent(hollow, angle_rad, pose);
  pose.reading.patency = hollow.patency(angle_rad, pose.reading.pressure_Pa);
  const double duration_s = tick_s_ * hollow.detorsion().timeScale;
  PerfusionState blood{pose.reading.flow, pose.congestion, pose.reading.dose, pose.saturation};
  hollow.vessels().step(blood, angle_rad, pose.reading.pressure_Pa / kPascalsPerMmHg, duration_s);
  pose.reading.flow = blood.flow;
  pose.reading.dose = blood.dose;
  pose.congestion = blood.congestion;
  pose.saturation = blood.saturation;
  pose.scaled_s += duration_s;
  press(hollow, jaw, organ, events);
  look(jaw, organ, events);
  ++ticks_;
}

void DetorsionStep::slip(const HollowOrgan& hollow, OrganState& organ, std::uint32_t& events) noexcept {
  const BaseFriction& base = hollow.detorsion().base;
  const double start_rad = std::abs(organ.hollow.start_rad);
  const double angle_rad = organ.twist.graspAngle_rad;
  const bool sameSide = (angle_rad < 0.0) == (organ.hollow.start_rad < 0.0);
  double size_rad = std::abs(angle_rad);
  if (sameSide && size_rad > base.relapseFrom_rad) {
    // Weight and gas bear what the wall asks, and turn the loop back where they are more.
    const bool falls = base.relapseShare > 0.0 && size_rad < start_rad;
    if (falls) {
      size_rad += (start_rad - base.relapseFrom_rad) * (tick_s_ / base.relapseTime_s);
      size_rad = std::min(size_rad, start_rad);
      events |= relapsing_ ? kEventNone : kEventRelapsing;
    }
    relapsing_ = falls;
  } else {
    relapsing_ = false;
    const double peak_Nm = hollow.basePeak_Nm();
    const double wall_Nm = std::abs(hollow.torque_Nm(size_rad, organ.hollow.reading.pressure_Pa));
    const double excess_Nm = wall_Nm - base.stickShare * peak_Nm;
    if (excess_Nm > 0.0) {
      size_rad -= start_rad * (excess_Nm / peak_Nm) * (tick_s_ / base.relapseTime_s);
      size_rad = std::max(size_rad, 0.0);
    }
  }
  organ.twist.graspAngle_rad = angle_rad < 0.0 ? -size_rad : size_rad;
}

void DetorsionStep::moveContent(const HollowOrgan& hollow, double angle_rad, HollowPose& pose) noexcept {
  const HollowWall& wall = hollow.detorsion().wall;
  if (ventAsked_ != Ask::kNothing) {
    pose.venting = ventAsked_ == Ask::kOn && wall.vent;
  }
  ventAsked_ = Ask::kNothing;
  double& pressure_Pa = pose.reading.pressure_Pa;
  if (wall.sealed && filled_) {
    pressure_Pa = hollow.sealedPressure_Pa(angle_rad, gas_J_);
  }
  if (pose.leaking) {
    pressure_Pa -= pressure_Pa * std::min(tick_s_ / kLeakTime_s, 1.0);
  } else if (pose.venting && pressure_Pa > wall.ventedPressure_Pa) {
    pressure_Pa -= (pressure_Pa - wall.ventedPressure_Pa) * std::min(tick_s_ / kVentTime_s, 1.0);
  }
  if (wall.sealed && (!filled_ || pose.leaking || pose.venting)) {
    gas_J_ = hollow.gas_J(angle_rad, pressure_Pa);
    filled_ = true;
  }
}

void DetorsionStep::press(const HollowOrgan& hollow, const JawState& jaw, OrganState& organ,
                          std::uint32_t& events) noexcept {
  HollowPose& pose = organ.hollow;
  const DetorsionLimits& limits = hollow.detorsion().limits;
  pose.jaw_Pa = jaw.holds ? jaw.closure * limits.jawForce_N / limits.jawArea_m2 : 0.0;
  if (!jaw.holds) {
    pressed_s_ = 0.0;
    bruised_ = false;
    torn_ = false;
    return;
  }
  const double strength = 1.0 - kIschaemicWeakness * std::min(pose.reading.dose, 1.0);
  pressed_s_ = pose.jaw_Pa >= strength * limits.bruise_Pa ? pressed_s_ + tick_s_ : 0.0;
  if (!torn_ && (pose.jaw_Pa >= strength * limits.tear_Pa || jaw.pull_N >= strength * limits.pull_N)) {
    torn_ = true;
    pose.leaking = true;
    mark(true, organ);
    events |= kEventTorn;
  }
  if (!bruised_ && pressed_s_ > 0.0 && pressed_s_ >= limits.bruise_s) {
    bruised_ = true;
    mark(false, organ);
    events |= kEventBruised;
  }
}

void DetorsionStep::mark(bool torn, OrganState& organ) const noexcept {
  HollowPose& pose = organ.hollow;
  if (pose.markCount < kMaxTissueMarks) {
    pose.marks[static_cast<std::size_t>(pose.markCount)] = {organ.twist.graspArc_m, round_rad_, ticks_, torn};
    ++pose.markCount;
  }
}

void DetorsionStep::look(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept {
  HollowPose& pose = organ.hollow;
  FlowReading& check = pose.check;
  const double angle_rad = organ.twist.graspAngle_rad;
  if (checkAsked_ != FlowCheck::kNone && check.running == FlowCheck::kNone) {
    check.running = checkAsked_;
    check.ready_us = jaw.time_us + flowCheckCost(checkAsked_).time_us;
    checkedAt_rad_ = angle_rad;
  }
  checkAsked_ = FlowCheck::kNone;
  if (check.running == FlowCheck::kNone) {
    return;
  }
  if (jaw.holds && std::abs(angle_rad - checkedAt_rad_) > kCheckTurn_rad) {
    check.running = FlowCheck::kNone;  // one hand cannot turn and feel
    check.ready_us = -1;
  } else if (jaw.time_us >= check.ready_us) {
    check.flow = told(pose.reading.flow, check.running, check.count);
    check.done = check.running;
    check.done_us = jaw.time_us;
    check.running = FlowCheck::kNone;
    check.ready_us = -1;
    ++check.count;
    events |= kEventChecked;
  }
}

double DetorsionStep::told(double flow, FlowCheck check, std::int32_t count) const noexcept {
  const std::uint64_t seed = mixedBits(seed_ + static_cast<std::uint64_t>(count));
  return std::clamp(flow + flowCheckCost(check).deviation * deviate(seed), 0.0, 1.0);
}

}  // namespace torsio
