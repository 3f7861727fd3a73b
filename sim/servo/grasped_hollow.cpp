// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/grasped_hollow.h"

#include <algorithm>
#include <cmath>

#include "sim/core/portable_math.h"

namespace torsio {

GraspedHollow::GraspedHollow(const Scene& scene, std::int64_t tickPeriod_us)
    : hollow_(scene.hollow.get()),
      lattice_(&scene.lattice()),
      stiffnessCap_N_per_m_(scene.model.options().stiffnessCap_N_per_m),
      detorsion_(tickPeriod_us) {}

OrganState GraspedHollow::start(std::uint64_t seed) {
  detorsion_.begin(seed);
  return hollow_->start(seed);
}

void GraspedHollow::apply(const ServoCommand& command) noexcept {
  switch (command.kind) {
    case ServoCommand::Kind::kHoldOrgan:
      detorsion_.hold(command.value != 0.0);
      break;
    case ServoCommand::Kind::kVent:
      detorsion_.vent(command.value != 0.0);
      break;
    case ServoCommand::Kind::kCheckFlow:
      detorsion_.check(static_cast<FlowCheck>(static_cast<int>(command.value)));
      break;
    default:
      break;
  }
}

double GraspedHollow::step(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept {
  detorsion_.step(*hollow_, jaw, organ, events);
  hollow_->lay(organ);
  if ((events & (kEventGripped | kEventUnclipped)) == 0 || !jaw.holds) {
    return 0.0;
  }
  const double angle_rad = organ.twist.graspAngle_rad;
  return hollow_->storedEnergy_J(angle_rad, organ.hollow.reading.pressure_Pa) +
         std::abs(DetorsionStep::relapse_Nm(*hollow_, organ) * angle_rad);
}

ToolState GraspedHollow::carried(const ToolState& tool, const JawMotion& motion,
                                 const OrganState& organ) const noexcept {
  ToolState carried = CommonTissue::carried(tool, motion, organ);
  if (lost_rad_ != 0.0) {
    carried.pose.orientation = axisAngle(motion.axis().tangent, -lost_rad_) * tool.pose.orientation;
  }
  return carried;
}

std::optional<AxisFrame> GraspedHollow::grip(const Vec3& held_m, double arc_m, const ToolState& /*tool*/,
                                             OrganState& organ) noexcept {
  const AxisFrame axis = hollow_->graspFrame(held_m);
  if (hollow_->placeOf(arc_m).span >= 0 || !(radiusAbout_m(axis, held_m) > kNearAxis_m)) {
    return std::nullopt;  // beside the mobile part, or no arm
  }
  organ.twist.graspArc_m = arc_m;
  const AxisFrame section = lattice_->frameAt(arc_m);
  const Vec3 fromAxis_m = held_m - section.centre_m;
  detorsion_.grip(portableAtan2(dot(fromAxis_m, section.e2), dot(fromAxis_m, section.e1)));
  turnFrom_rad_ = organ.twist.graspAngle_rad;
  wristFrom_rad_ = wristLeast_rad_ = wristMost_rad_ = slidFrom_rad_ = lost_rad_ = 0.0;
  return axis;
}

std::uint32_t GraspedHollow::follow(const ToolState& /*tool*/, JawMotion& motion,
                                    OrganState& organ) noexcept {
  double turn_rad = motion.turn_rad();
  const double asked_rad = wristFrom_rad_ + turn_rad;
  double wrist_rad = std::clamp(asked_rad, wristMost_rad_ - kHandTurn_rad, wristLeast_rad_ + kHandTurn_rad);
  if (!organ.hollow.clipped) {  // nor further than the organ goes
    wrist_rad =
        wristFrom_rad_ + (hollow_->within_rad(turnFrom_rad_ + wrist_rad - wristFrom_rad_) - turnFrom_rad_);
  }
  if (wrist_rad != asked_rad) {
    motion.takeOff(asked_rad - wrist_rad);  // turned back, it takes the organ along at once
    lost_rad_ += asked_rad - wrist_rad;
    turn_rad = wrist_rad - wristFrom_rad_;
  }
  wristLeast_rad_ = std::min(wristLeast_rad_, wrist_rad);
  wristMost_rad_ = std::max(wristMost_rad_, wrist_rad);
  if (!organ.hollow.clipped) {
    organ.twist.graspAngle_rad = turnFrom_rad_ + turn_rad;
    hollow_->lay(organ);
    slidFrom_rad_ = wrist_rad;
    return kEventNone;
  }
  motion.restart();
  turnFrom_rad_ = organ.twist.graspAngle_rad;
  wristFrom_rad_ = wrist_rad;
  return std::abs(wrist_rad - slidFrom_rad_) > kSlideTurn_rad ? kEventSlipped : kEventNone;
}

GripFeel GraspedHollow::feel(const Vec3& tip_m, const JawMotion& motion,
                             const OrganState& organ) const noexcept {
  if (organ.hollow.clipped) {
    return {};  // the clip bears the torque
  }
  constexpr double kSmallestArm_m = 1e-9;
  const double angle_rad = organ.twist.graspAngle_rad;
  const double pressure_Pa = organ.hollow.reading.pressure_Pa;
  GripFeel felt;
  felt.torque_Nm = hollow_->torque_Nm(angle_rad, pressure_Pa) - DetorsionStep::relapse_Nm(*hollow_, organ);
  const Vec3 way = cross(motion.axis().tangent, tip_m - motion.axis().centre_m);
  const double arm2 = dot(way, way);
  // The slope is negative beyond the peak: a pull that grows with the way is capped as one that falls.
  const double slope = std::abs(hollow_->slope_Nm_per_rad(angle_rad, pressure_Pa));
  if (arm2 > kSmallestArm_m * kSmallestArm_m) {
    felt.force_N = (-felt.torque_Nm / std::max(arm2, slope / stiffnessCap_N_per_m_)) * way;
  }
  return felt;
}

}  // namespace torsio
