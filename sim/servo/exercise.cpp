// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/exercise.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/error.h"
#include "sim/core/hollow_pose.h"
#include "sim/core/portable_math.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/indentation.h"

namespace torsio {

namespace {

constexpr std::uint32_t kHandGone = kDeviceLost | kDeviceUncalibrated | kDeviceEnded;
// Least share of the model's turn that the gripped section must follow; at a held end it follows none.
constexpr double kLeastShare = 0.1;

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

void check(const ExerciseOptions& options) {
  if (!(options.maxStiffness_N_per_m > 0.0) || !std::isfinite(options.maxStiffness_N_per_m) ||
      options.tickPeriod_us <= 0) {
    throw Error(
        ErrorCode::kBadParameter,
        Text::verbatim("stiffness and tick period must be above zero, got %1 N/m and %2 us",
                       std::to_string(options.maxStiffness_N_per_m), std::to_string(options.tickPeriod_us)),
        Text::verbatim("exercise"), Text::verbatim("Check what the device reports"));
  }
}

double surfaceStiffness_N_per_m(const ExerciseOptions& options) {
  check(options);
  return std::min(kSurfaceStiffness_N_per_m, options.maxStiffness_N_per_m);
}

/// Where the surface gives way by `depth_m` under a part.
ContactPatch patchUnder(const PartTouch& touch, double depth_m) noexcept {
  return {touch.point_m, touch.normal, depth_m, touch.radius_m, kPatchShare * touch.radius_m};
}

}  // namespace

Exercise::Exercise(const ExerciseOptions& options)
    : options_(options),
      jaw_(surfaceStiffness_N_per_m(options), options.tickPeriod_us),
      shaft_(surfaceStiffness_N_per_m(options), options.tickPeriod_us),
      detorsion_(options.tickPeriod_us) {
  returnFactor_ = portableExp(-static_cast<double>(options.tickPeriod_us) * 1e-6 / kReturnTime_s);
}

void Exercise::begin(const Scene& scene, std::uint64_t seed) {
  if (scene.hollow) {
    organ_ = scene.hollow->start(seed);
    detorsion_.begin(seed);
  }
}

bool Exercise::settled() const noexcept {
  return phase_ == ExercisePhase::kTracking && organ_ == OrganState{} && jaw_.untouched() &&
         shaft_.untouched() && !shaftTouched_ && !jawOpens_ && !gripPending_ && !releaseAsked_;
}

bool Exercise::jawCloses(bool wasClosed, const ToolState& tool) noexcept {
  const bool button = (tool.buttons & kButtonGrip) != 0;
  return button || tool.grip > (wasClosed ? kJawOpens : kJawCloses);
}

bool Exercise::updateJaw(const ToolState& tool) noexcept {
  const bool wasClosed = jawClosed_;
  jawClosed_ = jawCloses(wasClosed, tool);
  return jawClosed_ && !wasClosed;
}

bool Exercise::grip(const Vec3& held_m, const ToolState& tool, const Scene& scene) noexcept {
  const Vec3& tip_m = tool.pose.position_m;
  const double arc_m = scene.lattice().nearestArc_m(held_m);
  if (scene.rod) {
    rodGrasp_.close(*scene.rod, arc_m, tool.pose, organ_);
    axis_ = rodGrasp_.axis();
  } else {
    axis_ = scene.hollow ? scene.hollow->graspFrame(held_m) : scene.model.graspFrame(arc_m);
    const bool follows = scene.hollow ? scene.hollow->placeOf(arc_m).span < 0
                                      : scene.model.angleAt(arc_m, {arc_m, 1.0}) > kLeastShare;
    if (!follows || !(about(axis_, held_m).radius_m > kNearAxis_m)) {
      return false;  // held there, or no arm: nothing to twist
    }
    organ_.twist = {arc_m, scene.hollow ? organ_.twist.graspAngle_rad : 0.0};
  }
  const AxisFrame section = scene.hollow ? scene.lattice().frameAt(arc_m) : axis_;
  const Vec3 fromAxis_m = held_m - section.centre_m;
  gripRound_rad_ = portableAtan2(dot(fromAxis_m, section.e2), dot(fromAxis_m, section.e1));
  gripAngle_rad_ = organ_.twist.graspAngle_rad;
  heldFrom_rad_ = gripAngle_rad_;
  tipFrom_rad_ = tipAngle(tool);
  grippedAt_ = tool.pose.orientation;
  const Cylindrical at = about(axis_, tip_m);
  gripRadius_m_ = at.radius_m;
  gripHeight_m_ = at.height_m;
  angle_rad_ = 0.0;
  firstAngle_rad_ = driveAngle(tool);
  angle_rad_ = firstAngle_rad_;
  wristFrom_rad_ = wristLeast_rad_ = wristMost_rad_ = slidFrom_rad_ = lost_rad_ = 0.0;
  ++grips_;
  beside_.grip();
  return true;
}

double Exercise::tipAngle(const ToolState& tool) const noexcept {
  const Vec3 way = tool.pose.position_m - axis_.centre_m;
  return portableAtan2(dot(way, axis_.e2), dot(way, axis_.e1));
}

double Exercise::driveAngle(const ToolState& tool) const noexcept {
  if (options_.drive == TwistDrive::kRoll) {
    return unwrapNear(turnAbout(axis_.tangent, grippedAt_, tool.pose.orientation), angle_rad_);
  }
  const Vec3 way = tool.pose.position_m - axis_.centre_m;
  const double x = dot(way, axis_.e1);
  const double y = dot(way, axis_.e2);
  if (!(x * x + y * y >= kNearAxis_m * kNearAxis_m)) {
    return angle_rad_;  // also of a place that is not finite
  }
  return unwrapNear(tipAngle(tool), angle_rad_);
}

ToolState Exercise::onTissue(const ToolState& tool, const Scene& scene) const noexcept {
  ToolState carried = tool;
  if (phase_ == ExercisePhase::kTwisting && options_.drive == TwistDrive::kRoll && !scene.rod &&
      options_.rules >= kRulesOfStoredEnergy) {
    const double alone_rad = tipAngle(tool) - tipFrom_rad_;
    const double turn_rad = organ_.twist.graspAngle_rad - heldFrom_rad_ - alone_rad;
    carried.pose.position_m =
        axis_.centre_m + rotateAbout(tool.pose.position_m - axis_.centre_m, axis_.tangent, turn_rad);
    if (lost_rad_ != 0.0) {
      carried.pose.orientation = axisAngle(axis_.tangent, -lost_rad_) * tool.pose.orientation;
    }
  }
  return carried;
}

Vec3 Exercise::gripOffset(const ToolState& tool, const Scene& scene) const noexcept {
  if (scene.rod && scene.rod->task().axis != GripAxis::kOwn) {
    return {};  // the coupling holds the place
  }
  const Cylindrical at = about(axis_, tool.pose.position_m);
  return at.outwards * (at.radius_m - gripRadius_m_) + axis_.tangent * (at.height_m - gripHeight_m_);
}

bool Exercise::turnMobilePart(double turn_rad) noexcept {
  const double asked_rad = wristFrom_rad_ + turn_rad;
  const double wrist_rad =
      std::clamp(asked_rad, wristMost_rad_ - kHandTurn_rad, wristLeast_rad_ + kHandTurn_rad);
  if (wrist_rad != asked_rad) {
    firstAngle_rad_ += asked_rad - wrist_rad;  // turned back, it takes the organ along at once
    lost_rad_ += asked_rad - wrist_rad;
    turn_rad = wrist_rad - wristFrom_rad_;
  }
  wristLeast_rad_ = std::min(wristLeast_rad_, wrist_rad);
  wristMost_rad_ = std::max(wristMost_rad_, wrist_rad);
  if (!organ_.hollow.clipped) {
    organ_.twist.graspAngle_rad = gripAngle_rad_ + turn_rad;
    slidFrom_rad_ = wrist_rad;
    return false;
  }
  firstAngle_rad_ = angle_rad_;
  gripAngle_rad_ = organ_.twist.graspAngle_rad;
  wristFrom_rad_ = wrist_rad;
  return std::abs(wrist_rad - slidFrom_rad_) > kSlideTurn_rad;
}

DetorsionHand Exercise::detorsionHand(const ToolState& tool) const noexcept {
  const bool grips = (tool.buttons & kButtonGrip) != 0;
  return {.time_us = tool.time_us,
          .holds = phase_ == ExercisePhase::kTwisting,
          .touches = phase_ == ExercisePhase::kContact,
          .secondButton = (tool.buttons & kButtonSecond) != 0,
          .closure = grips ? 1.0 : std::clamp(tool.grip, 0.0, 1.0),
          .pull_N = lastPull_N_,
          .arc_m = organ_.twist.graspArc_m,
          .round_rad = gripRound_rad_};
}

std::uint32_t Exercise::follow(const ToolState& tool, const Scene& scene) noexcept {
  angle_rad_ = driveAngle(tool);
  const double turn_rad = angle_rad_ - firstAngle_rad_;
  bool slips = false;
  if (scene.rod) {
    rodGrasp_.follow(*scene.rod, tool.pose, turn_rad, options_.drive, tick_s(), organ_);
    if (rodGrasp_.folds()) {
      return kEventFolded;
    }
    slips = rodGrasp_.drawnBeyond(kSlipWay_m);
  } else if (scene.hollow) {
    slips = turnMobilePart(turn_rad);
  } else {
    organ_.twist.graspAngle_rad = turn_rad;
  }
  const Vec3 offset = gripOffset(tool, scene);
  slips = slips || !(dot(offset, offset) <= kSlipWay_m * kSlipWay_m);
  return slips ? kEventSlipped : kEventNone;
}

void Exercise::letGo(std::uint32_t why, std::uint32_t& events) noexcept {
  phase_ = ExercisePhase::kReleased;
  jawOpens_ = options_.rules >= kRulesOfStoredEnergy;
  events |= why;
}

void Exercise::relax(bool touching, const Scene& scene, std::uint32_t& events) noexcept {
  if (scene.hollow) {
    // It stays where its base holds it.
    phase_ = touching ? ExercisePhase::kContact : ExercisePhase::kTracking;
    events |= touching ? kEventTouched : kEventNone;
    return;
  }
  if (scene.rod) {
    if (rodGrasp_.relax(*scene.rod, tick_s(), organ_) == RodReturn::kMoving) {
      return;
    }
  } else {
    organ_.twist.graspAngle_rad *= returnFactor_;
    if (std::abs(organ_.twist.graspAngle_rad) > kAtRest_rad) {
      return;
    }
    organ_ = {};
  }
  phase_ = touching ? ExercisePhase::kContact : ExercisePhase::kTracking;
  events |= touching ? (kEventReturned | kEventTouched) : kEventReturned;
}

void Exercise::moveOn(double gap_m, const std::optional<SurfacePoint>& held, const ToolState& tool,
                      const Scene& scene, std::uint32_t& events) noexcept {
  const bool touching = gap_m < 0.0;
  const bool gripsNext = held && phase_ == ExercisePhase::kTracking;
  gripPending_ = gripsNext;  // a grip begins with one tick of contact
  switch (phase_) {
    case ExercisePhase::kTracking:
      if (!touching && !gripsNext) {
        break;
      }
      phase_ = ExercisePhase::kContact;
      events |= kEventTouched;
      break;
    case ExercisePhase::kContact:
      if (held && grip(held->position_m, tool, scene)) {
        phase_ = ExercisePhase::kTwisting;
        events |= kEventGripped;
      } else if (gap_m > kContactHysteresis_m) {
        phase_ = ExercisePhase::kTracking;
        events |= kEventLeft;
      }
      break;
    case ExercisePhase::kTwisting:
      break;
    case ExercisePhase::kReleased:
      // A release is seen for one tick at least, also of an organ that was not turned.
      if ((events & kEventReleased) == 0) {
        relax(touching, scene, events);
      }
      break;
  }
}

Vec3 Exercise::pushBack(const ToolTouch& at, std::array<ContactPatch, 2>& patches) noexcept {
  const bool holding = phase_ == ExercisePhase::kTwisting;
  Vec3 force_N;
  if (jawOpens_) {
    jaw_.anchor(-at.jaw.gap_m);
    jawOpens_ = false;
  }
  const double jaw_m = jaw_.step(holding ? 0.0 : -at.jaw.gap_m);
  if (jaw_m > 0.0) {
    patches[0] = patchUnder(at.jaw, jaw_m);
    force_N += at.jaw.normal * jaw_.force_N();
  }
  const double shaft_m = shaft_.step(-at.shaft.gap_m);
  if (shaft_m > 0.0) {
    patches[1] = patchUnder(at.shaft, shaft_m);
    force_N += at.shaft.normal * shaft_.force_N();
  }
  return force_N;
}

void Exercise::feelWrung(const Vec3& tip_m, const Scene& scene, TwistResponse& response) const noexcept {
  if (organ_.hollow.clipped) {
    return;  // the clip bears the torque
  }
  constexpr double kSmallestArm_m = 1e-9;
  const double angle_rad = organ_.twist.graspAngle_rad;
  const double pressure_Pa = organ_.hollow.reading.pressure_Pa;
  response.torque_Nm =
      scene.hollow->torque_Nm(angle_rad, pressure_Pa) - DetorsionStep::relapse_Nm(*scene.hollow, organ_);
  const Vec3 way = cross(axis_.tangent, tip_m - axis_.centre_m);
  const double arm2 = dot(way, way);
  // The slope is negative beyond the peak: a pull that grows with the way is capped as one that falls.
  const double slope = std::abs(scene.hollow->slope_Nm_per_rad(angle_rad, pressure_Pa));
  const double cap_N_per_m = scene.model.options().stiffnessCap_N_per_m;
  if (arm2 > kSmallestArm_m * kSmallestArm_m) {
    response.force_N = (-response.torque_Nm / std::max(arm2, slope / cap_N_per_m)) * way;
  }
}

void Exercise::feelGrip(const ToolState& tool, const Scene& scene, TwistResponse& response,
                        std::uint32_t& limits) const noexcept {
  const Vec3& tip_m = tool.pose.position_m;
  if (runsBeside(scene.tissue)) {
    if (beside_.doubtful()) {
      limits |= kForceModelLate;
      return;
    }
    const double cap_N_per_m = scene.model.options().stiffnessCap_N_per_m;
    response.torque_Nm = beside_.torque_Nm(organ_.twist.graspAngle_rad);
    response.force_N = beside_.force_N(organ_.twist.graspAngle_rad, axis_, tip_m, cap_N_per_m);
  } else if (scene.rod) {
    response.torque_Nm = rodGrasp_.torque_Nm();
    response.force_N = rodGrasp_.force_N(*scene.rod, tip_m);
  } else if (scene.hollow) {
    feelWrung(tip_m, scene, response);
  } else {
    response.torque_Nm = scene.model.torque_Nm(organ_.twist);
    response.force_N = scene.model.graspForce_N(organ_.twist, tip_m);
  }
  response.force_N -= gripOffset(tool, scene) * kGripStiffness_N_per_m;
}

TwistResponse Exercise::responseTo(const ToolTouch& at, const ToolState& tool, const Scene& scene,
                                   ExerciseStep& answer) noexcept {
  TwistResponse response;
  response.depth_m = std::max(0.0, -at.jaw.gap_m);
  response.angle_rad = organ_.twist.graspAngle_rad;
  response.graspArc_m = organ_.twist.graspArc_m;
  lastPull_N_ = 0.0;
  if (phase_ == ExercisePhase::kTwisting) {
    feelGrip(tool, scene, response, answer.limits);
    lastPull_N_ = norm(response.force_N);
  }
  response.force_N += pushBack(at, answer.patches);
  return response;
}

void Exercise::noteContacts(const ToolTouch& at, ExerciseStep& answer) noexcept {
  const bool holding = phase_ == ExercisePhase::kTwisting;
  if (holding) {
    answer.contact |= kContactHeld;
  }
  if (!holding && at.jaw.gap_m < 0.0) {
    answer.contact |= kContactJaw;
  }
  if (at.shaft.gap_m < 0.0) {
    answer.contact |= kContactShaft;
  }
  const bool leaves = at.shaft.gap_m > kContactHysteresis_m;
  if (!shaftTouched_ && at.shaft.gap_m < 0.0) {
    answer.events |= kEventShaftTouched;
  }
  if (shaftTouched_ && leaves) {
    answer.events |= kEventShaftLeft;
  }
  shaftTouched_ = at.shaft.gap_m < 0.0 || (shaftTouched_ && !leaves);
}

ExerciseStep Exercise::step(const ToolState& tool, const Scene& scene) noexcept {
  ExerciseStep answer;
  const bool closing = updateJaw(tool);
  const bool letGoNow = !jawClosed_ || (tool.status & kHandGone) != 0 || releaseAsked_;
  releaseAsked_ = false;
  if (scene.hollow) {
    detorsion_.setHolders(detorsionHand(tool), organ_, answer.events);
  }
  if (phase_ == ExercisePhase::kTwisting) {
    if (letGoNow) {
      letGo(kEventReleased, answer.events);
    } else if (const std::uint32_t end = follow(tool, scene); end != kEventNone) {
      letGo(kEventReleased | end, answer.events);
    }
  }
  const ToolShape shape = toolShape(onTissue(tool, scene), scene.instrument);
  const ToolTouch at = touchTool(shape, scene, organ_, phase_ == ExercisePhase::kTwisting, memory_);
  const bool closes = (closing || gripPending_) && !letGoNow &&
                      (phase_ == ExercisePhase::kTracking || phase_ == ExercisePhase::kContact);
  const std::optional<SurfacePoint> held = closes ? tissueInMouth(shape, tool, scene, organ_) : std::nullopt;
  moveOn(std::min(at.jaw.gap_m, at.shaft.gap_m), held, tool, scene, answer.events);
  if (scene.hollow) {
    detorsion_.step(*scene.hollow, detorsionHand(tool), organ_, answer.events);
    if ((answer.events & (kEventGripped | kEventUnclipped)) != 0 && phase_ == ExercisePhase::kTwisting) {
      const double angle_rad = organ_.twist.graspAngle_rad;
      answer.lent_J = scene.hollow->storedEnergy_J(angle_rad, organ_.hollow.reading.pressure_Pa) +
                      std::abs(DetorsionStep::relapse_Nm(*scene.hollow, organ_) * angle_rad);
    }
  }
  answer.phase = phase_;
  answer.response = responseTo(at, tool, scene, answer);
  noteContacts(at, answer);
  return answer;
}

}  // namespace torsio
