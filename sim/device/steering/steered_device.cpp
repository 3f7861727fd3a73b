// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/steering/steered_device.h"

#include <chrono>
#include <utility>

#include "sim/core/clock.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr auto kPollEvery = std::chrono::milliseconds(1);
constexpr std::size_t kMaxEvents = 256;

}  // namespace

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
  Published reading;
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
  const Published& newest = readings_.latest();
  if (!read_ || newest.number != lastNumber_) {
    lastNew_us_ = time_us;
  }
  read_ = true;
  lastNumber_ = newest.number;
  DeviceSample sample = newest.sample;
  const std::int64_t age_us = time_us - lastNew_us_;
  if (newest.number == 0 || age_us > kSteeringStale_us) {
    sample.status |= kDeviceStale;
  }
  if (age_us > kSteeringLost_us) {
    sample.status |= kDeviceLost;
  }
  sample.time_us = time_us;
  return sample;
}

}  // namespace torsio
