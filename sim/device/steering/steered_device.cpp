// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/steering/steered_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "sim/core/clock.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

/// The user's right is the patient's left (x), up is towards the head (z), towards the user is towards the
/// patient's front (-y): a quarter turn about x.
constexpr Quat kUserToWorld{0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1, 0.0, 0.0};

bool isFinite(const SteeringInput& input) noexcept {
  return isFinite(input.move) && std::isfinite(input.yaw) && std::isfinite(input.pitch) &&
         std::isfinite(input.roll) && std::isfinite(input.grip);
}

double unit(double value) noexcept {
  return std::clamp(value, -1.0, 1.0);
}

constexpr auto kPollEvery = std::chrono::milliseconds(1);
constexpr std::size_t kMaxEvents = 256;

}  // namespace

double steeringCurve(double deflection, double dead) noexcept {
  const double size = std::min(std::abs(deflection), 1.0);
  if (!(size > dead)) {
    return 0.0;
  }
  const double share = (size - dead) / (1.0 - dead);
  return std::copysign(share * share, deflection);
}

RateSteering::RateSteering(const Vec3& start_m, const Vec3& centre_m) noexcept
    : centre_m_(centre_m), position_m_(start_m) {}

void RateSteering::step(const SteeringInput& input, double step_s) noexcept {
  invalid_ = !isFinite(input);
  if (invalid_) {
    return;
  }
  const double time_s = std::clamp(step_s, 0.0, kSteeringStepMost_s);
  const double share = time_s / (kSteeringSmoothing_s + time_s);
  move_ += (Vec3{unit(input.move.x), unit(input.move.y), unit(input.move.z)} - move_) * share;
  yaw_ += (unit(input.yaw) - yaw_) * share;
  pitch_ += (unit(input.pitch) - pitch_) * share;
  roll_ += (unit(input.roll) - roll_) * share;
  grip_ += (std::clamp(input.grip, 0.0, 1.0) - grip_) * share;
  buttons_ = input.buttons;

  const Vec3 goal_m = position_m_ + rotate(kUserToWorld, move_) * (kSteeringSpeed_m_per_s * time_s);
  const auto within = [](double value_m, double middle_m) {
    return std::clamp(value_m, middle_m - kSteeringReach_m, middle_m + kSteeringReach_m);
  };
  position_m_ = {within(goal_m.x, centre_m_.x), within(goal_m.y, centre_m_.y), within(goal_m.z, centre_m_.z)};
  const auto tilted = [time_s](double angle_rad, double rate) {
    return std::clamp(angle_rad + rate * kSteeringTilt_rad_per_s * time_s, -kSteeringTiltMost_rad,
                      kSteeringTiltMost_rad);
  };
  yaw_rad_ = tilted(yaw_rad_, yaw_);
  pitch_rad_ = tilted(pitch_rad_, pitch_);
  roll_rad_ += roll_ * kSteeringRoll_rad_per_s * time_s;
}

DeviceReading RateSteering::reading(std::int64_t time_us) const noexcept {
  DeviceReading reading;
  reading.time_us = time_us;
  reading.pose.position_m = position_m_;
  reading.pose.orientation = kUserToWorld * axisAngle({0.0, 1.0, 0.0}, yaw_rad_) *
                             axisAngle({1.0, 0.0, 0.0}, pitch_rad_) * axisAngle({0.0, 0.0, 1.0}, roll_rad_);
  reading.roll_rad = roll_rad_;
  reading.grip = grip_;
  reading.buttons = buttons_ | (grip_ > 0.5 ? static_cast<std::uint32_t>(kButtonGrip) : 0U);
  reading.status = invalid_ ? kDeviceInvalid : kDeviceOk;
  return reading;
}

SteeredDevice::SteeredDevice(std::unique_ptr<SteeringSource> source, DeviceIdentity identity,
                             const DeviceRequest& request)
    : source_(std::move(source)),
      identity_(std::move(identity)),
      steering_(request.start.position_m, request.workspaceCentre_m),
      events_(kMaxEvents) {
  const Vec3 reach_m{kSteeringReach_m, kSteeringReach_m, kSteeringReach_m};
  capabilities_.model = identity_.model;
  capabilities_.workspaceMin_m = request.workspaceCentre_m - reach_m;
  capabilities_.workspaceMax_m = request.workspaceCentre_m + reach_m;
  capabilities_.drive = TwistDrive::kRoll;  // what is pushed cannot be led round an organ: it turns
}

SteeredDevice::~SteeredDevice() {
  (void)close();
}

void SteeredDevice::serve() {
  TORSIO_EXPECTS(!thread_.joinable() && !closed_);
  thread_ = std::thread([this] { follow(); });
}

bool SteeredDevice::close() {
  ending_.store(true);
  if (thread_.joinable()) {
    thread_.join();
  }
  closed_ = true;
  source_.reset();
  return true;
}

/// The driver's thread, until the end or the loss of the device.
void SteeredDevice::follow() {
  const MonotonicClock clock;
  const std::int64_t begun_us = clock.now_us();
  std::int64_t last_us = begun_us;
  TickMeter meter;
  DeviceSnapshot snapshot;
  snapshot.calibration = CalibrationState::kCalibrated;
  MailedReading reading;
  while (!ending_.load(std::memory_order_relaxed)) {
    const std::int64_t now_us = clock.now_us();
    (void)meter.begin(now_us);
    const std::optional<SteeringInput> input = source_->poll();
    snapshot.state = input ? DeviceState::kReady : DeviceState::kLost;
    if (input) {
      steering_.step(*input, 1e-6 * static_cast<double>(now_us - last_us));
    }
    last_us = now_us;
    const std::uint32_t before = reading.sample.buttons;
    reading.sample = quantize(steering_.reading(now_us - begun_us), reading.sample);
    reading.sample.status |= input ? 0U : static_cast<std::uint32_t>(kDeviceLost | kDeviceStale);
    ++reading.number;
    readings_.publish(reading);
    ++((reading.sample.status & kDeviceInvalid) == 0 ? snapshot.validPoses : snapshot.invalidPoses);
    if (reading.sample.buttons != before) {
      (void)events_.push({DeviceEvent::Kind::kButtons, now_us - begun_us, reading.sample.buttons, 0, 0});
    }
    snapshot.sample = reading.sample;
    meter.end(clock.now_us());
    snapshot.timing = meter.values();
    snapshots_.publish(snapshot);
    if (!input) {
      (void)events_.push({DeviceEvent::Kind::kLost, now_us - begun_us, 0, 0, 0});
      return;  // the user opens it again
    }
    std::this_thread::sleep_for(kPollEvery);
  }
}

DeviceSnapshot SteeredDevice::snapshot() noexcept {
  DeviceSnapshot snapshot = snapshots_.latest();
  if (closed_) {
    snapshot.state = DeviceState::kClosed;
  }
  return snapshot;
}

DeviceSample SteeredDevice::read(std::int64_t time_us) noexcept {
  return age_.marked(readings_.latest(), time_us);
}

}  // namespace torsio
