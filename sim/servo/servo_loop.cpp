// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/float_mode.h"
#include "sim/core/live_types.h"

namespace torsio {

namespace {

const HapticDevice& deviceOf(const ServoLoop::Links& links) {
  TORSIO_EXPECTS(links.device != nullptr && links.scene != nullptr);
  return *links.device;
}

GovernorLimits governorLimits(const ServoLoop::Links& links, const ServoOptions& options) {
  const DeviceCapabilities& device = deviceOf(links).capabilities();
  return {.maxForce_N = device.maxForce_N,
          .continuousForce_N = device.continuousForce_N,
          .workspaceMin_m = device.workspaceMin_m,
          .workspaceMax_m = device.workspaceMax_m,
          .tickPeriod_us = options.tickPeriod_us,
          .fallsFreely = options.rules >= kRulesOfStoredEnergy,
          .fadesAtOnce = options.rules >= kRulesOfStandstill};
}

bool isFinite(const TwistResponse& response) noexcept {
  return std::isfinite(response.angle_rad) && std::isfinite(response.torque_Nm) &&
         torsio::isFinite(response.force_N) && std::isfinite(response.depth_m) &&
         std::isfinite(response.graspArc_m);
}

constexpr std::uint32_t kNoHand = kDeviceLost | kDeviceUncalibrated | kDeviceInvalid | kDeviceEnded;

HandReading handOf(std::uint32_t status) noexcept {
  if ((status & kNoHand) != 0) {
    return HandReading::kNone;
  }
  return (status & kDeviceStale) != 0 ? HandReading::kStandsStill : HandReading::kFresh;
}

bool inUnitRange(double value) noexcept {
  return value >= 0.0 && value <= 1.0;  // false for NaN
}

bool isFlowCheck(double value) noexcept {
  constexpr auto kLast = static_cast<double>(FlowCheck::kDoppler);
  return value >= 1.0 && value <= kLast && value == std::floor(value);
}

}  // namespace

ServoOptions servoOptions(const TrialHeader& header) noexcept {
  return {.drive = header.drive,
          .targetAngle_rad = header.targetAngle_rad,
          .forceScale = header.forceScale,
          .tickPeriod_us = header.tickPeriod_us,
          .seed = header.seed.value_or(detorsionSeed(header.trialId))};
}

DeviceLimits deviceLimits(const DeviceCapabilities& capabilities) noexcept {
  return {.maxForce_N = capabilities.maxForce_N,
          .continuousForce_N = capabilities.continuousForce_N,
          .maxStiffness_N_per_m = capabilities.maxStiffness_N_per_m,
          .workspaceMin_m = capabilities.workspaceMin_m,
          .workspaceMax_m = capabilities.workspaceMax_m};
}

ExerciseOptions ServoLoop::exerciseOptions(const DeviceCapabilities& device,
                                           const ServoOptions& options) noexcept {
  return {.drive = options.drive,
          .maxStiffness_N_per_m = device.maxStiffness_N_per_m,
          .tickPeriod_us = options.tickPeriod_us,
          .rules = options.rules};
}

ServoLoop::ServoLoop(const Links& links, const ServoOptions& options)
    : ServoLoop(links, options, PinnedFloatMode()) {}

ServoLoop::ServoLoop(const Links& links, const ServoOptions& options, const PinnedFloatMode& /*defaults*/)
    : links_(links),
      options_(options),
      exercise_(exerciseOptions(deviceOf(links).capabilities(), options), *links.scene, options.seed),
      passivity_({.tickPeriod_us = options.tickPeriod_us}),
      governor_(governorLimits(links, options)),
      storedEnergy_(
          {.tickPeriod_us = options.tickPeriod_us, .countsHiddenWays = options.rules >= kRulesOfStandstill}) {
  if (!inUnitRange(options.forceScale) || !std::isfinite(options.targetAngle_rad)) {
    throw Error(ErrorCode::kBadParameter,
                Text::verbatim("the force scale must lie in 0..1 and the target be finite, got %1 and %2",
                               std::to_string(options.forceScale), std::to_string(options.targetAngle_rad)),
                Text::verbatim("servo loop"), Text::verbatim("Check the exercise's options"));
  }
  sample_.rules = stampedRules(options.rules, links.scene->comesTwisted());
}

void ServoLoop::tick(std::int64_t time_us, const ExerciseStep* known) noexcept {
  const auto begun = std::chrono::steady_clock::now();
  const PinnedFloatMode defaults;
  countLate(time_us);
  sample_.tick = nextTick_++;
  sample_.command = nextCommand();
  apply(sample_.command);
  sample_.async = asyncAnswer();
  exercise_.takeAnswer(sample_.async);

  sample_.device = links_.device->read(time_us);
  if (options_.holdsBack) {
    sample_.device = proxy_.held(sample_.device);
  }
  sample_.device.time_us = time_us;
  const ToolState tool = toolState(sample_.device);
  const ExerciseStep step = known != nullptr ? *known : exercise_.step(tool);
  if (options_.holdsBack) {
    proxy_.note(step, options_.drive, *links_.scene, exercise_.organ());
  }
  askAsyncModel();
  noteEvents(step);
  std::uint32_t damped = kForceFull;
  const Vec3 wanted_N = wantedForce_N(step, tool, damped);
  ForceCommand force = governor_.govern({.now_us = time_us,
                                         .computed_us = time_us,
                                         .wanted_N = wanted_N,
                                         .tip_m = tool.pose.position_m,
                                         .deviceStatus = tool.status});
  if (energyLast()) {
    if ((step.events & (kEventGripped | kEventReleased)) != 0) {
      storedEnergy_.forget();
    }
    storedEnergy_.lend(step.lent_J);
    force.force_N =
        storedEnergy_.limited(tool.pose.position_m, force.force_N, handOf(tool.status), force.limits);
  } else {
    passivity_.sent(force.force_N);
  }
  links_.device->write(force);
  sample_.force_N = force.force_N;
  sample_.limits = force.limits | damped | step.limits;

  // A refused sample is counted by the ring.
  if (links_.recording != nullptr) {
    (void)links_.recording->push(sample_);
  }
  publish();
  lastTickDuration_us_ =
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count();
}

Vec3 ServoLoop::wantedForce_N(const ExerciseStep& step, const ToolState& tool,
                              std::uint32_t& limits) noexcept {
  const bool finite = isFinite(step.response) && readHollow();
  // No NaN enters a record; the governor still sees it and inhibits.
  sample_.response = finite ? step.response : TwistResponse{};
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Vec3 scaled_N = finite ? step.response.force_N * options_.forceScale : Vec3{kNaN, 0.0, 0.0};
  if (energyLast()) {
    return scaled_N;
  }
  const bool sound = finite && (tool.status & kNoHand) == 0;
  const Vec3 passive_N =
      passivity_.control(sample_.device.time_us, tool.pose.position_m, scaled_N, sound, limits);
  return finite ? passive_N : scaled_N;
}

bool ServoLoop::readHollow() noexcept {
  const HollowPose& pose = exercise_.organ().hollow;
  if (!pose.present) {
    return true;
  }
  const HollowReading& now = pose.reading;
  const bool finite = std::isfinite(now.pressure_Pa) && std::isfinite(now.patency) &&
                      std::isfinite(now.flow) && std::isfinite(now.dose);
  if (finite) {
    soundReading_ = now;
  }
  sample_.hollow = soundReading_;
  return finite;
}

void ServoLoop::noteEvents(const ExerciseStep& step) noexcept {
  const std::int64_t now_us = sample_.device.time_us;
  if (step.phase != sample_.phase || nextTick_ == 1) {
    times_.phaseSince_us = now_us;
  }
  if ((step.events & kEventTouched) != 0) {
    times_.touched_us = now_us;
  }
  if ((step.events & kEventGripped) != 0) {
    times_.gripped_us = now_us;
  }
  if ((step.events & kEventReleased) != 0) {
    times_.released_us = now_us;
  }
  if ((step.events & kEventSlipped) != 0) {
    times_.slipped_us = now_us;
  }
  if ((step.events & kEventFolded) != 0) {
    times_.folded_us = now_us;
  }
  if ((step.events & kEventReturned) != 0) {
    times_.returned_us = now_us;
  }
  events_ = step.events;
  sample_.phase = step.phase;
  sample_.contact = step.contact;
  patches_ = step.patches;
  if (links_.events == nullptr || events_ == kEventNone) {
    return;
  }
  // A refused moment is counted by the ring; the phases of the samples still tell it.
  (void)links_.events->push({sample_.tick, now_us, events_, step.phase});
}

ServoCommand ServoLoop::nextCommand() noexcept {
  ServoCommand command;
  if (links_.commands == nullptr || !links_.commands->pop(command)) {
    return {};
  }
  // What makes no sense is not obeyed and not recorded.
  if (!std::isfinite(command.value)) {
    return {};
  }
  if (command.kind == ServoCommand::Kind::kSetForceScale && !inUnitRange(command.value)) {
    return {};
  }
  if (command.kind == ServoCommand::Kind::kCheckFlow && !isFlowCheck(command.value)) {
    return {};
  }
  return command;
}

void ServoLoop::apply(const ServoCommand& command) noexcept {
  switch (command.kind) {
    case ServoCommand::Kind::kSetForceScale:
      options_.forceScale = command.value;
      break;
    case ServoCommand::Kind::kSetTarget:
      options_.targetAngle_rad = command.value;
      break;
    case ServoCommand::Kind::kEnableForce:
      governor_.enable(command.value != 0.0);
      break;
    default:
      exercise_.apply(command);
      break;
  }
}

AsyncAnswer ServoLoop::asyncAnswer() noexcept {
  if (links_.async == nullptr) {
    return {};
  }
  const AsyncDelivery& newest = links_.async->deliveries.latest();
  const bool news = newest.number != lastDelivery_;
  lastDelivery_ = newest.number;
  if (!news || newest.grip != exercise_.grips() || exercise_.phase() != ExercisePhase::kTwisting) {
    return {};
  }
  const AsyncAnswer& answer = newest.answer;
  const bool finite = std::isfinite(answer.angle_rad) && std::isfinite(answer.torque_Nm) &&
                      std::isfinite(answer.slope_Nm_per_rad);
  return answer.state == AsyncState::kSound && finite ? answer : AsyncAnswer{.state = AsyncState::kBroken};
}

void ServoLoop::askAsyncModel() noexcept {
  if (links_.async != nullptr) {
    const TwistState& twist = exercise_.organ().twist;
    links_.async->questions.publish({exercise_.grips(), twist.graspArc_m, twist.graspAngle_rad});
  }
}

void ServoLoop::countLate(std::int64_t time_us) noexcept {
  // More than half a period late counts as a missed tick; a gap of n periods as n - 1 missed ones.
  const std::int64_t period_us = options_.tickPeriod_us;
  if (nextTick_ > 0) {
    const std::int64_t periods = (time_us - last_us_ + period_us / 2) / period_us;
    if (periods > 1) {
      lateTicks_ += periods - 1;
    }
    forceCuts_ += time_us - last_us_ > kLongestTickGap_us ? 1 : 0;
  }
  last_us_ = time_us;
}

void ServoLoop::publish() noexcept {
  if (links_.live == nullptr) {
    return;
  }
  LiveState live = liveStateOf(sample_);
  live.targetAngle_rad = options_.targetAngle_rad;
  live.tickDuration_us = lastTickDuration_us_;
  live.refusedSamples =
      links_.recording != nullptr ? static_cast<std::int64_t>(links_.recording->refused()) : 0;
  live.lateTicks = lateTicks_;
  live.deviceStatus = sample_.device.status;
  live.patches = patches_;
  live.times = times_;
  live.pose = exercise_.organ().pose;
  live.hollow = exercise_.organ().hollow;
  live.portEnergy_J = portEnergy_J();
  links_.live->publish(live);
}

}  // namespace torsio
