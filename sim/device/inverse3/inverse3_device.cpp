// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/inverse3/inverse3_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/clock.h"
#include "sim/core/contracts.h"
#include "sim/core/deadline.h"

namespace torsio {

namespace {

constexpr std::size_t kMaxEvents = 256;
constexpr std::int64_t kLook_us = 5'000;
constexpr double kGripTime_s = 0.1;
/// Middle of the workspace as third parties' examples place it; measure your own.
constexpr Vec3 kCentre_m{0.0, -0.14, 0.2};
/// Half the edge of the cube about it that is used.
constexpr double kHalf_m = 0.1;
/// From a stylus along -z to one that points away from the user (y): a quarter turn about x.
constexpr Quat kAway{0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1, 0.0, 0.0};

}  // namespace

Inverse3Device::Inverse3Device(std::unique_ptr<WebSocket> service, const Inverse3Message& first,
                               const DeviceRequest& request)
    : service_(std::move(service)),
      deviceId_(first.deviceId),
      origin_m_(request.workspaceCentre_m - kCentre_m),
      events_(kMaxEvents) {
  identity_.model = "Inverse3";
  identity_.vendor = "Haply";
  identity_.serial = first.deviceId;
  identity_.driverVersion = first.firmware;
  identity_.openedAs = first.deviceId;
  identity_.inputDof = first.orientation ? 6 : 3;
  identity_.outputDof = 3;
  identity_.assumed = {Text::tr("maximum force"), Text::tr("usable workspace")};
  identity_.notes.push_back(Text::tr("this kind of device was not confirmed on hardware yet"));
  if (!first.orientation) {
    identity_.notes.push_back(Text::tr("no handle is connected: the jaw cannot be turned or closed"));
  }
  const Vec3 half_m{kHalf_m, kHalf_m, kHalf_m};
  capabilities_.model = identity_.model;
  capabilities_.workspaceMin_m = request.workspaceCentre_m - half_m;
  capabilities_.workspaceMax_m = request.workspaceCentre_m + half_m;
  capabilities_.rendersForce = true;
  reading_.pose.orientation = kAway;
}

Inverse3Device::~Inverse3Device() {
  (void)close();
}

void Inverse3Device::start(const DeviceTick& tick) {
  TORSIO_EXPECTS(!thread_.joinable() && !closed_);
  tick_ = tick;
  thread_ = std::thread([this] { follow(); });
}

void Inverse3Device::beginClose() {
  ending_.store(true);
  while (inTick_.load()) {
    std::this_thread::sleep_for(std::chrono::microseconds(50));  // it may go before the driver's thread
  }
}

bool Inverse3Device::close() {
  beginClose();
  if (thread_.joinable()) {
    thread_.join();
  }
  closed_ = true;
  service_.reset();
  released_.store(true, std::memory_order_release);
  return true;
}

/// The driver's thread, until the end or the loss of the device.
void Inverse3Device::follow() {
  (void)requestRealTime(RealTimeRank::kServo);
  const MonotonicClock clock;
  begun_us_ = clock.now_us();
  taken_us_ = begun_us_;
  TickMeter meter;
  std::string text;
  service_->send(inverse3Force(deviceId_, {}));  // the service answers commands
  while (!ending_.load(std::memory_order_relaxed)) {
    const bool came = service_->receive(text, kLook_us);
    const std::int64_t now_us = clock.now_us();
    if (service_->closed() || now_us - taken_us_ > kInverse3Lost_us) {
      break;
    }
    if (came) {
      (void)meter.begin(now_us);
    }
    answer(came, text, now_us);
    if (came) {
      meter.end(clock.now_us());
      state_.timing = meter.values();
    }
    snapshots_.publish(state_);
  }
  service_->send(inverse3Force(deviceId_, {}));
  if (!ending_.load()) {
    state_.state = DeviceState::kLost;
    publish(kDeviceLost | kDeviceStale, clock.now_us());
    runTick(clock.now_us());
    snapshots_.publish(state_);
    (void)events_.push({DeviceEvent::Kind::kLost, clock.now_us() - begun_us_, 0, 0, 0});
  }
  released_.store(true, std::memory_order_release);
}

/// Reads, lets the tick answer, and sends the force; none while the position of the hand is unknown.
void Inverse3Device::answer(bool came, const std::string& text, std::int64_t now_us) {
  const bool valid = came && take(text, now_us);
  if (came) {
    ++(valid ? state_.validPoses : state_.invalidPoses);
  }
  publish(valid ? kDeviceOk : (came ? kDeviceInvalid : kDeviceStale), now_us);
  runTick(now_us);
  if (!valid) {
    gate_.close();
  }
  const Vec3 force_N = valid ? allowedForce_N(now_us) : Vec3{};
  service_->send(inverse3Force(deviceId_, force_N));
  state_.forcesSent += norm(force_N) > 0.0 ? 1 : 0;
}

void Inverse3Device::runTick(std::int64_t now_us) {
  if (tick_.run == nullptr) {
    return;
  }
  // Sequentially consistent: either beginClose() sees this tick and waits, or this tick sees the end.
  inTick_.store(true);
  if (!ending_.load()) {
    tick_.run(tick_.context, now_us - begun_us_);
  }
  inTick_.store(false);
}

bool Inverse3Device::take(const std::string& text, std::int64_t now_us) {
  const std::optional<Inverse3Message> message = inverse3Message(text, deviceId_);
  if (!message || message->deviceId != deviceId_ || !message->cursor_m) {
    return false;
  }
  keep(*message, now_us);
  return true;
}

/// Makes the reading of a valid message: the device's axes are those of the world.
void Inverse3Device::keep(const Inverse3Message& message, std::int64_t now_us) {
  const double step_s = 1e-6 * static_cast<double>(std::clamp<std::int64_t>(now_us - taken_us_, 0, 100'000));
  taken_us_ = now_us;
  reading_.pose.position_m = origin_m_ + *message.cursor_m;
  if (message.orientation) {
    const Quat before = reading_.pose.orientation;
    reading_.pose.orientation = *message.orientation * kAway;
    const Vec3 axis = rotate(before, {0.0, 0.0, 1.0});
    reading_.roll_rad += unwrapNear(turnAbout(axis, before, reading_.pose.orientation), 0.0);
  }
  const double goal = (message.buttons & kButtonGrip) != 0 ? 1.0 : 0.0;
  const double most = step_s / kGripTime_s;
  reading_.grip += std::clamp(goal - reading_.grip, -most, most);
  if (reading_.buttons != message.buttons) {
    (void)events_.push({DeviceEvent::Kind::kButtons, now_us - begun_us_, message.buttons, 0, 0});
  }
  reading_.buttons = message.buttons;
}

void Inverse3Device::publish(std::uint32_t trouble, std::int64_t now_us) {
  reading_.time_us = now_us - begun_us_;
  published_.sample = quantize(reading_, published_.sample);
  published_.sample.status |= trouble;
  ++published_.number;
  readings_.publish(published_);
  state_.sample = published_.sample;
  if (state_.state != DeviceState::kLost) {
    state_.calibration = state_.validPoses > 0 ? CalibrationState::kCalibrated : CalibrationState::kUnknown;
    state_.rollReferenced = true;  // the handle knows its own zero
    state_.forceOn = forceWished_.load(std::memory_order_relaxed);
    state_.state = state_.forceOn ? DeviceState::kRunning : DeviceState::kReady;
  } else {
    state_.forceOn = false;
  }
}

/// The force that may be sent now, N.
Vec3 Inverse3Device::allowedForce_N(std::int64_t now_us) {
  const MailedForce wanted = forces_.latest();
  if (wanted.number != forceNumber_) {
    forceNumber_ = wanted.number;
    forceNew_us_ = now_us;
  }
  const std::uint32_t drops = drops_.load(std::memory_order_relaxed);
  if (drops != dropsSeen_) {
    dropsSeen_ = drops;
    droppedNumber_ = wanted.number;
    gate_.close();
  }
  const bool mayPush = forceWished_.load(std::memory_order_relaxed) && wanted.number > droppedNumber_ &&
                       now_us - forceNew_us_ <= kInverse3Stale_us && isFinite(wanted.force_N);
  if (!mayPush) {
    gate_.close();
  }
  const double share = gate_.advance(std::clamp<std::int64_t>(now_us - sent_us_, 0, kServoPeriod_us));
  sent_us_ = now_us;
  const double size_N = norm(wanted.force_N);
  if (!mayPush || !(size_N > 0.0)) {
    return {};
  }
  return wanted.force_N * (share * std::min(1.0, capabilities_.maxForce_N / size_N));
}

DeviceSnapshot Inverse3Device::snapshot() noexcept {
  DeviceSnapshot snapshot = snapshots_.latest();
  if (closed_) {
    snapshot.state = DeviceState::kClosed;
    snapshot.forceOn = false;
  }
  return snapshot;
}

DeviceSample Inverse3Device::read(std::int64_t time_us) noexcept {
  const MailedReading& newest = readings_.latest();
  if (!read_ || newest.number != lastNumber_) {
    lastNew_us_ = time_us;
  }
  read_ = true;
  lastNumber_ = newest.number;
  DeviceSample sample = newest.sample;
  const std::int64_t age_us = time_us - lastNew_us_;
  if (newest.number == 0) {
    sample.status |= kDeviceStale | kDeviceUncalibrated;
  }
  if (age_us > 2 * kLook_us) {
    sample.status |= kDeviceStale;
  }
  if (age_us > kInverse3Lost_us) {
    sample.status |= kDeviceLost;
  }
  sample.time_us = time_us;
  return sample;
}

void Inverse3Device::write(const ForceCommand& command) noexcept {
  wanted_ = {command.force_N, wanted_.number + 1};
  forces_.publish(wanted_);
}

}  // namespace torsio
