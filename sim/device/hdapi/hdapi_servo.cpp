// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/hdapi/hdapi_servo.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace torsio {

namespace {

constexpr std::size_t kEventCapacity = 1024;
constexpr std::size_t kMaxMotors = 6;
// Joints turn by less than a circle; anything far beyond is garbage.
constexpr double kLargestAngle_rad = 20.0;

bool areAngles(const std::array<double, 3>& angles_rad) noexcept {
  return std::all_of(angles_rad.begin(), angles_rad.end(),
                     [](double angle_rad) { return std::abs(angle_rad) < kLargestAngle_rad; });
}

}  // namespace

HdapiServo::HdapiServo(const hd::Api& api, const HdapiSetup& setup, const Clock& clock)
    : api_(api), setup_(setup), clock_(clock), events_(kEventCapacity) {}

hd::CallbackCode HdapiServo::frame() noexcept {
  if (lost() || lettingGo_.load(std::memory_order_acquire)) {
    return hd::kCallbackDone;
  }
  inFrame_.store(true, std::memory_order_release);
  const std::int64_t now_us = clock_.now_us();
  called_us_.store(now_us, std::memory_order_relaxed);
  if (!started_) {
    begun_us_ = now_us;
    taken_us_ = now_us;
  }
  started_ = true;
  interval_us_ = meter_.begin(now_us);
  if (interval_us_ > kServoGap_us) {
    gate_.close();
    note(DeviceEvent::Kind::kGap, now_us, static_cast<std::uint32_t>(interval_us_));
  }
  takeWishes();
  frameOpen_ = beginFrame(now_us);
  if (frameOpen_ && !lost()) {
    readDevice(now_us);
  }
  judge(now_us);
  runTick(now_us);
  const bool lostBefore = lost();
  sendForce(now_us);
  if (updateNeeded_ && !lost()) {
    updateCalibration(now_us);
  }
  if (lost() && !lostBefore) {
    // The connection broke off after the sample was made, and there will be no other frame to say so.
    judge(now_us);
    runTick(now_us);
  }
  inFrame_.store(false, std::memory_order_release);
  if (lost() || revoked_.load(std::memory_order_relaxed)) {
    letGo(true);
    snapshot_.forceOn = api_.hdIsEnabled(hd::kForceOutput) != 0;
    (void)drainHdapiErrors(api_);
  }
  meter_.end(clock_.now_us());
  publish();
  return lost() || silent() ? hd::kCallbackDone : hd::kCallbackContinue;
}

void HdapiServo::letGo(bool afterFrame) noexcept {
  if (lettingGo_.exchange(true)) {
    return;
  }
  if (!zeroSent_ && !inFrame_.load(std::memory_order_acquire)) {
    if (afterFrame) {
      api_.hdDisable(hd::kOneFrameLimit);
    }
    api_.hdBeginFrame(setup_.handle);
    if (!drainHdapiErrors(api_).any(HdapiErrorClass::kFrame)) {
      constexpr std::array<double, 3> kZero_N{};
      api_.hdSetDoublev(hd::kCurrentForce, kZero_N.data());
      api_.hdEndFrame(setup_.handle);
    }
  }
  api_.hdDisable(hd::kForceOutput);
  (void)drainHdapiErrors(api_);
  silent_.store(true, std::memory_order_release);
}

void HdapiServo::takeWishes() noexcept {
  if (calibrationWished_.exchange(false, std::memory_order_relaxed)) {
    calibration_.retry();
  }
}

bool HdapiServo::beginFrame(std::int64_t now_us) noexcept {
  api_.hdBeginFrame(setup_.handle);
  // A frame that was refused must not be ended; after any other error it is open and has to be.
  if (!drain(now_us).any(HdapiErrorClass::kFrame)) {
    return true;
  }
  refuseFrame(now_us);
  return false;
}

/// The motors go on with what the last frame gave them: the output is switched off, and a device that refuses
/// all frames is lost.
void HdapiServo::refuseFrame(std::int64_t now_us) noexcept {
  ++snapshot_.refusedFrames;
  if (now_us - taken_us_ >= kFramesRefused_us && !lost()) {
    lose({hd::kFrameError, 0, setup_.handle}, now_us);
  }
}

void HdapiServo::readDevice(std::int64_t now_us) noexcept {
  HdapiFrame frame;
  api_.hdGetDoublev(hd::kCurrentTransform, frame.transform_mm.data());
  api_.hdGetDoublev(hd::kCurrentJointAngles, frame.joints_rad.data());
  api_.hdGetDoublev(hd::kCurrentGimbalAngles, frame.gimbal_rad.data());
  readSwitches(now_us);
  readTemperature();
  if (calibration_.due(now_us)) {
    checkCalibration(now_us);
  }
  const bool answered = drain(now_us).worst < HdapiErrorClass::kLicence;

  reading_.status = kDeviceOk;
  const std::optional<Pose> pose = worldPose(frame, setup_.placement);
  if (!answered || !pose || !areAngles(frame.joints_rad) || !areAngles(frame.gimbal_rad)) {
    reading_.status = kDeviceInvalid;
    ++snapshot_.invalidPoses;
    return;
  }
  ++snapshot_.validPoses;
  const double gimbalRoll_rad = trueGimbal_rad(setup_.gimbal, frame.gimbal_rad)[2];
  noteJump(*pose, now_us);
  reading_.pose = *pose;
  snapshot_.docked = isDocked(frame);
  const bool wasFrozen = snapshot_.frozen;
  snapshot_.frozen = liveness_.frozen(frame, snapshot_.docked);
  if (snapshot_.frozen && !wasFrozen) {
    note(DeviceEvent::Kind::kFrozen, now_us);
  }
  const bool wasAtStop = snapshot_.rollAtStop;
  roll_.follow(gimbalRoll_rad);
  if (snapshot_.docked && calibration_.calibrated() && !roll_.referenced()) {
    roll_.reference();
  }
  reading_.roll_rad = roll_.turn_rad();
  snapshot_.rollReferenced = roll_.referenced();
  snapshot_.rollAtStop = roll_.atStop();
  if (snapshot_.rollAtStop && !wasAtStop) {
    note(DeviceEvent::Kind::kRollStop, now_us);
  }
  if (!setup_.gimbal.armKnown) {
    return;
  }
  const std::array<double, 16> computed_mm = touchTransform_mm(frame.joints_rad, {});
  snapshot_.geometryError_m =
      1e-3 * norm(Vec3{computed_mm[12] - frame.transform_mm[12], computed_mm[13] - frame.transform_mm[13],
                       computed_mm[14] - frame.transform_mm[14]});
}

void HdapiServo::readSwitches(std::int64_t now_us) noexcept {
  hd::Int raw = 0;
  api_.hdGetIntegerv(hd::kCurrentButtons, &raw);
  const std::uint32_t before = reading_.buttons;
  reading_.buttons = buttons_.filter(static_cast<std::uint32_t>(raw), now_us);
  if (reading_.buttons != before) {
    note(DeviceEvent::Kind::kButtons, now_us, reading_.buttons);
  }
  followGrip(now_us);
  if (!setup_.hasInkwellSwitch) {
    return;
  }
  hd::Boolean inkwell = 0;
  api_.hdGetBooleanv(hd::kCurrentInkwellSwitch, &inkwell);
  snapshot_.inkwellSwitch = inkwell != 0;
}

void HdapiServo::followGrip(std::int64_t) noexcept {
  const std::int64_t step_us = (reading_.buttons & kButtonGrip) != 0 ? interval_us_ : -interval_us_;
  grip_us_ = std::clamp<std::int64_t>(grip_us_ + step_us, 0, kGripTime_us);
  reading_.grip = static_cast<double>(grip_us_) / static_cast<double>(kGripTime_us);
}

void HdapiServo::readTemperature() noexcept {
  if (!setup_.hasTemperature) {
    return;
  }
  // Three values on a device with three motors, six on one with six.
  std::array<double, kMaxMotors> motors{};
  api_.hdGetDoublev(hd::kMotorTemperature, motors.data());
  double warmest = 0.0;
  for (const double motor : motors) {
    if (motor > warmest) {
      warmest = motor;  // false for NaN
    }
  }
  snapshot_.warmest = warmest;
  if (warmest > kWarmAbove) {
    warm_ = true;
  }
  if (warmest < kWarmUntilBelow) {
    warm_ = false;
    warmStop_ = false;
  }
}

void HdapiServo::checkCalibration(std::int64_t now_us) noexcept {
  const CalibrationState before = calibration_.state();
  updateNeeded_ = calibration_.answered(api_.hdCheckCalibration(), now_us);
  if (calibration_.state() != before) {
    note(DeviceEvent::Kind::kCalibration, now_us, static_cast<std::uint32_t>(calibration_.state()));
  }
}

void HdapiServo::updateCalibration(std::int64_t now_us) noexcept {
  updateNeeded_ = false;
  api_.hdUpdateCalibration(setup_.calibrationStyle);
  const HdapiErrors errors = drainHdapiErrors(api_);
  for (std::size_t i = 0; i < errors.count; ++i) {
    note(DeviceEvent::Kind::kError, now_us, 0, errors.entries[i]);
    // Here a device fault only says that the calibration did not succeed.
    const hd::ErrorCode code = errors.entries[i].error;
    if (hdapiErrorClass(code) == HdapiErrorClass::kFatal && code != hd::kDeviceFault) {
      lose(errors.entries[i], now_us);
    }
  }
  calibration_.updated(errors.count > 0);
  if (calibration_.state() == CalibrationState::kFailed) {
    note(DeviceEvent::Kind::kCalibration, now_us, static_cast<std::uint32_t>(CalibrationState::kFailed));
  }
}

void HdapiServo::noteJump(const Pose& pose, std::int64_t now_us) noexcept {
  if (lastPose_) {
    const auto since_us = std::max<std::int64_t>(now_us - lastPose_us_, kServoPeriod_us);
    const double reach_m = kFastestHand_m_per_s * 1e-6 * static_cast<double>(since_us);
    if (norm(pose.position_m - lastPose_->position_m) > reach_m) {
      ++snapshot_.jumps;
      distrustUntil_us_ = now_us + kJumpSettles_us;
      note(DeviceEvent::Kind::kJump, now_us);
    }
  }
  lastPose_ = pose;
  lastPose_us_ = now_us;
}

void HdapiServo::judge(std::int64_t now_us) noexcept {
  const bool slow = meter_.values().slow;
  std::uint32_t status = reading_.status & kDeviceInvalid;
  if (lost()) {
    status |= kDeviceLost;
  }
  if (lost() || !frameOpen_ || slow || warmStop_) {
    status |= kDeviceStale;
  }
  if (snapshot_.frozen) {
    status |= kDeviceStale | kDeviceUncalibrated;  // the position of the hand is unknown
  }
  if (!calibration_.calibrated() || now_us < distrustUntil_us_) {
    status |= kDeviceUncalibrated;
  }
  // Amplifiers that dropped out leave no hand at the organ: contact and grip start anew, too.
  if (tripped_) {
    status |= kDeviceInvalid | kDeviceUncalibrated;
  }
  tripped_ = false;
  if (warm_ || warmStop_) {
    status |= kDeviceWarm;
  }
  if ((status & ~static_cast<std::uint32_t>(kDeviceWarm)) != 0) {
    gate_.close();
  }
  reading_.status = status;
  reading_.time_us = now_us - begun_us_;
  snapshot_.sample = quantize(reading_, snapshot_.sample);
  // A device that refuses a frame goes on with its last force: only the output can be switched off then.
  const bool revoked = revoked_.load(std::memory_order_relaxed);
  if (!revoked) {
    const bool quick = meter_.values().rate_Hz > 0.0 && !slow;  // not before the rate is known
    switchForce(forceWished_.load(std::memory_order_relaxed) && calibration_.calibrated() && quick &&
                !warmStop_ && !endRefused_ && (frameOpen_ || lost()));
  }
  chooseState(slow || warmStop_);
}

void HdapiServo::chooseState(bool slowOrWarm) noexcept {
  if (lost()) {
    snapshot_.state = DeviceState::kLost;
  } else if (!calibration_.calibrated()) {
    snapshot_.state = DeviceState::kNeedsCalibration;
  } else if (slowOrWarm) {
    snapshot_.state = DeviceState::kDegraded;
  } else {
    snapshot_.state = snapshot_.forceOn ? DeviceState::kRunning : DeviceState::kReady;
  }
}

void HdapiServo::switchForce(bool on) noexcept {
  if (!on) {
    gate_.close();
  }
  if (on == snapshot_.forceOn || lost()) {
    return;
  }
  (on ? api_.hdEnable : api_.hdDisable)(hd::kForceOutput);
  snapshot_.forceOn = api_.hdIsEnabled(hd::kForceOutput) != 0;
}

void HdapiServo::runTick(std::int64_t now_us) noexcept {
  readings_.publish({snapshot_.sample, ++frames_});
  if (tick_.run == nullptr) {
    return;
  }
  // Sequentially consistent: either revokeTick() sees this tick and waits, or this tick sees the revocation.
  inTick_.store(true);
  if (!revoked_.load()) {
    tick_.run(tick_.context, now_us - begun_us_);
  }
  inTick_.store(false);
}

void HdapiServo::revokeTick() noexcept {
  revoked_.store(true);
  while (inTick_.load()) {
    // Not a yield: a waiting thread of higher rank would keep the servo from ending its tick.
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
}

Vec3 HdapiServo::forceToSend(std::int64_t now_us) noexcept {
  if (tick_.run == nullptr) {
    command_ = forces_.latest();
  }
  if (command_.number != seenForce_) {
    seenForce_ = command_.number;
    seenForce_us_ = now_us;
  }
  const bool expired = seenForce_ == 0 || now_us - seenForce_us_ > kForceExpires_us;
  const double size_N = norm(command_.force_N);
  const bool asked = dropAsked_.exchange(false, std::memory_order_relaxed);
  if (asked || expired || !std::isfinite(size_N) || revoked_.load(std::memory_order_relaxed)) {
    gate_.close();
  }
  const std::int64_t step_us = std::clamp<std::int64_t>(interval_us_, 0, kServoPeriod_us);
  const double gain = gate_.advance(step_us);
  if (!(gain > 0.0)) {
    rendered_N_ = {};
    return {};
  }
  const Vec3 asked_N = command_.force_N * (gain * setup_.maxForce_N / std::max(size_N, setup_.maxForce_N));
  if (tick_.run != nullptr) {
    return asked_N;
  }
  // Over mailboxes several ticks of the other side may fall between two frames: their rises do not add up.
  const Vec3 kept_N = keptForce_N(rendered_N_, asked_N);
  const Vec3 rise_N = asked_N - kept_N;
  const double most_N = kSlewLimit_N_per_s * 1e-6 * static_cast<double>(step_us);
  const double rise = norm(rise_N);
  rendered_N_ = rise > most_N ? kept_N + rise_N * (most_N / rise) : asked_N;
  return rendered_N_;
}

void HdapiServo::sendForce(std::int64_t now_us) noexcept {
  if (!frameOpen_) {
    return;
  }
  std::array<double, 3> force_N{};
  if (!lost()) {
    force_N = deviceForce(forceToSend(now_us), setup_.placement);
  }
  api_.hdSetDoublev(hd::kCurrentForce, force_N.data());
  api_.hdEndFrame(setup_.handle);
  frameOpen_ = false;
  const HdapiErrors errors = drain(now_us);
  const bool taken = errors.count == 0;
  endRefused_ = errors.any(HdapiErrorClass::kFrame);
  if (endRefused_) {
    refuseFrame(now_us);
    switchForce(false);
  } else {
    taken_us_ = now_us;
  }
  const bool zero = force_N == std::array<double, 3>{};
  zeroSent_ = zero && taken;
  if (!zero && !endRefused_) {
    ++(taken ? snapshot_.forcesSent : snapshot_.forcesRefused);
  }
}

HdapiErrors HdapiServo::drain(std::int64_t now_us) noexcept {
  const HdapiErrors errors = drainHdapiErrors(api_);
  for (std::size_t i = 0; i < errors.count; ++i) {
    const hd::ErrorInfo& error = errors.entries[i];
    note(DeviceEvent::Kind::kError, now_us, 0, error);
    switch (hdapiErrorClass(error.error)) {
      case HdapiErrorClass::kForce:
        ++snapshot_.forceTrips;
        tripped_ = true;
        gate_.close();
        break;
      case HdapiErrorClass::kWarm:
        warmStop_ = true;
        gate_.close();
        break;
      case HdapiErrorClass::kFrame:
        gate_.close();
        break;
      case HdapiErrorClass::kLicence:
      case HdapiErrorClass::kFatal:
        lose(error, now_us);
        break;
      default:
        ++snapshot_.refusedCalls;
    }
  }
  return errors;
}

void HdapiServo::lose(const hd::ErrorInfo& error, std::int64_t now_us) noexcept {
  if (!lost()) {
    snapshot_.lostBecause = error.error;
    note(DeviceEvent::Kind::kLost, now_us, 0, error);
  }
  snapshot_.state = DeviceState::kLost;
  lost_.store(true, std::memory_order_release);
}

void HdapiServo::publish() noexcept {
  snapshot_.calibration = calibration_.state();
  snapshot_.timing = meter_.values();
  snapshot_.refusedEvents = static_cast<std::int64_t>(events_.refused());
  snapshots_.publish(snapshot_);
}

void HdapiServo::note(DeviceEvent::Kind kind, std::int64_t now_us, std::uint32_t value,
                      const hd::ErrorInfo& error) noexcept {
  (void)events_.push({kind, now_us - begun_us_, value, error.error, error.internalError});
}

}  // namespace torsio
