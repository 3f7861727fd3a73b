// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/exercise.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/error.h"
#include "sim/servo/contact_coupling.h"

namespace torsio {

namespace {

constexpr std::uint32_t kHandGone = kDeviceLost | kDeviceUncalibrated | kDeviceEnded;
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

Exercise::Exercise(const ExerciseOptions& options, const Scene& scene, std::uint64_t seed)
    : options_(options),
      scene_(&scene),
      tissue_(scene, options.tickPeriod_us),
      organ_(tissue_.start(seed)),
      motion_(options.drive),
      jaw_(surfaceStiffness_N_per_m(options), options.tickPeriod_us),
      shaft_(surfaceStiffness_N_per_m(options), options.tickPeriod_us) {}

void Exercise::apply(const ServoCommand& command) noexcept {
  releaseAsked_ = releaseAsked_ || command.kind == ServoCommand::Kind::kReleaseTissue;
  tissue_.apply(command);
}

bool Exercise::settled() const noexcept {
  return settles() && phase_ == ExercisePhase::kTracking && organ_ == OrganState{} && jaw_.untouched() &&
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

JawState Exercise::jawState(const ToolState& tool) const noexcept {
  const bool grips = (tool.buttons & kButtonGrip) != 0;
  return {.time_us = tool.time_us,
          .holds = phase_ == ExercisePhase::kTwisting,
          .touches = phase_ == ExercisePhase::kContact,
          .secondButton = (tool.buttons & kButtonSecond) != 0,
          .closure = grips ? 1.0 : std::clamp(tool.grip, 0.0, 1.0),
          .pull_N = lastPull_N_};
}

bool Exercise::grip(const Vec3& held_m, const ToolState& tool) noexcept {
  const double arc_m = scene_->lattice().nearestArc_m(held_m);
  const std::optional<AxisFrame> axis = tissue_.grip(held_m, arc_m, tool, organ_);
  if (!axis) {
    return false;
  }
  motion_.close(*axis, tool, organ_.twist.graspAngle_rad);
  ++grips_;
  return true;
}

std::uint32_t Exercise::follow(const ToolState& tool) noexcept {
  motion_.follow(tool);
  if (const std::uint32_t end = tissue_.follow(tool, motion_, organ_); end != kEventNone) {
    return end;
  }
  const Vec3 drift = drift_m(tool);
  return dot(drift, drift) <= kSlipWay_m * kSlipWay_m ? kEventNone : kEventSlipped;  // also of a NaN
}

Vec3 Exercise::drift_m(const ToolState& tool) const noexcept {
  return tissue_.keepsJaw() ? Vec3{} : motion_.drift_m(tool);
}

ToolState Exercise::onTissue(const ToolState& tool) const noexcept {
  const bool carries = phase_ == ExercisePhase::kTwisting && options_.drive == TwistDrive::kRoll &&
                       options_.rules >= kRulesOfStoredEnergy;
  return carries ? tissue_.carried(tool, motion_, organ_) : tool;
}

void Exercise::letGo(std::uint32_t why, std::uint32_t& events) noexcept {
  phase_ = ExercisePhase::kReleased;
  jawOpens_ = options_.rules >= kRulesOfStoredEnergy;
  events |= why;
}

void Exercise::relax(bool touching, std::uint32_t& events) noexcept {
  const TissueReturn became = tissue_.relax(organ_);
  if (became == TissueReturn::kMoving) {
    return;
  }
  phase_ = touching ? ExercisePhase::kContact : ExercisePhase::kTracking;
  events |= became == TissueReturn::kReturned ? kEventReturned : kEventNone;
  events |= touching ? kEventTouched : kEventNone;
}

void Exercise::moveOn(double gap_m, const std::optional<SurfacePoint>& held, const ToolState& tool,
                      std::uint32_t& events) noexcept {
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
      if (held && grip(held->position_m, tool)) {
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
        relax(touching, events);
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

void Exercise::feelGrip(const ToolState& tool, TwistResponse& response,
                        std::uint32_t& limits) const noexcept {
  const GripFeel felt = tissue_.feel(tool.pose.position_m, motion_, organ_);
  if (felt.late) {
    limits |= kForceModelLate;
    return;
  }
  response.torque_Nm = felt.torque_Nm;
  response.force_N = felt.force_N - drift_m(tool) * kGripStiffness_N_per_m;
}

TwistResponse Exercise::responseTo(const ToolTouch& at, const ToolState& tool,
                                   ExerciseStep& answer) noexcept {
  TwistResponse response;
  response.depth_m = std::max(0.0, -at.jaw.gap_m);
  response.angle_rad = organ_.twist.graspAngle_rad;
  response.graspArc_m = organ_.twist.graspArc_m;
  lastPull_N_ = 0.0;
  if (phase_ == ExercisePhase::kTwisting) {
    feelGrip(tool, response, answer.limits);
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

ExerciseStep Exercise::step(const ToolState& tool) noexcept {
  ExerciseStep answer;
  const bool closing = updateJaw(tool);
  const bool letGoNow = !jawClosed_ || (tool.status & kHandGone) != 0 || releaseAsked_;
  releaseAsked_ = false;
  tissue_.setHolders(jawState(tool), organ_, answer.events);
  if (phase_ == ExercisePhase::kTwisting) {
    if (letGoNow) {
      letGo(kEventReleased, answer.events);
    } else if (const std::uint32_t end = follow(tool); end != kEventNone) {
      letGo(kEventReleased | end, answer.events);
    }
  }
  const ToolShape shape = toolShape(onTissue(tool), scene_->instrument);
  const ToolTouch at = touchTool(shape, *scene_, organ_, phase_ == ExercisePhase::kTwisting, memory_);
  const bool closes = (closing || gripPending_) && !letGoNow &&
                      (phase_ == ExercisePhase::kTracking || phase_ == ExercisePhase::kContact);
  const std::optional<SurfacePoint> held =
      closes ? tissueInMouth(shape, tool, *scene_, organ_) : std::nullopt;
  moveOn(std::min(at.jaw.gap_m, at.shaft.gap_m), held, tool, answer.events);
  answer.lent_J = tissue_.step(jawState(tool), organ_, answer.events);
  answer.phase = phase_;
  answer.response = responseTo(at, tool, answer);
  noteContacts(at, answer);
  return answer;
}

}  // namespace torsio
