// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/hdapi/hdapi_device.h"

#include <chrono>
#include <thread>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/device/hdapi/hdapi_library.h"

namespace torsio {

HdapiDevice::HdapiDevice(const hd::Api& api, const HdapiOptions& options)
    : session_(std::make_shared<HdapiSession>(api, options)), patience_us_(options.patience_us) {}

HdapiDevice::~HdapiDevice() {
  (void)close();
}

void HdapiDevice::start(const DeviceTick& tick) {
  TORSIO_EXPECTS(!started_);
  driven_ = tick.run != nullptr;
  started_ = true;
  lastTick_ = std::chrono::steady_clock::now();
  session_->start(tick);
}

void HdapiDevice::beginClose() {
  if (closed_.valid()) {
    return;
  }
  session_->servo().revokeTick();
  std::promise<void> promise;
  closed_ = promise.get_future();
  // The thread keeps the session alive for as long as the library holds on to it.
  std::thread([session = session_, released = released_, done = std::move(promise)]() mutable {
    session->tearDown();
    released->store(true, std::memory_order_release);
    done.set_value();
  }).detach();
}

bool HdapiDevice::close() {
  beginClose();
  // Patience is spent once; later calls only look.
  const std::chrono::microseconds patience(waited_ ? 0 : patience_us_);
  waited_ = true;
  return closed_.wait_for(patience) == std::future_status::ready;
}

bool HdapiDevice::released() const {
  return released_->load(std::memory_order_acquire);
}

DeviceSnapshot HdapiDevice::snapshot() noexcept {
  DeviceSnapshot snapshot = session_->servo().newestSnapshot();
  const auto now = std::chrono::steady_clock::now();
  if (snapshot.timing.ticks != lastTicks_) {
    lastTicks_ = snapshot.timing.ticks;
    lastTick_ = now;
  }
  if (closed_.valid()) {
    snapshot.state = DeviceState::kClosed;
  } else if (started_ && snapshot.state != DeviceState::kLost &&
             now - lastTick_ > std::chrono::microseconds(kServoSilent_us)) {
    snapshot.state = DeviceState::kSilent;
  }
  return snapshot;
}

Text HdapiDevice::lossText(std::uint32_t code) const {
  return hdapiErrorText(code);
}

DeviceSample HdapiDevice::read(std::int64_t time_us) noexcept {
  if (!driven_) {
    return age_.marked(session_->servo().newestReading(), time_us);
  }
  DeviceSample sample = session_->servo().current();
  sample.time_us = time_us;
  return sample;
}

void HdapiDevice::write(const ForceCommand& command) noexcept {
  if (driven_) {
    session_->servo().send(command.force_N);
    return;
  }
  force_ = {command.force_N, force_.number + 1};
  session_->servo().publishForce(force_);
}

}  // namespace torsio
