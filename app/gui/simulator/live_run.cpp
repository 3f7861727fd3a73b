// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/live_run.h"

#include <utility>

#include "sim/base/contracts.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kCommandsWaiting = 64;
constexpr std::int64_t kTick_us = 1000;

}  // namespace

ServoOptions LiveRun::options(const RunSetup& setup) {
  ServoOptions options;
  options.drive = setup.drive;
  options.targetAngle_rad = setup.targetAngle_rad;
  options.tickPeriod_us = kTick_us;
  return options;
}

LiveRun::LiveRun(std::shared_ptr<const Scene> scene, const RunSetup& setup,
                 std::unique_ptr<HapticDevice> device)
    : scene_(std::move(scene)),
      pointer_(setup.start),
      device_(std::move(device)),
      commands_(kCommandsWaiting),
      loop_({.device = &this->device(), .scene = scene_.get(), .live = &live_, .commands = &commands_},
            options(setup)),
      thread_(loop_, kTick_us) {}

LiveRun::LiveRun(std::shared_ptr<const Scene> scene, const RunSetup& setup, TrialHeader header,
                 std::unique_ptr<TrialSink> sink)
    : LiveRun(std::move(scene), setup, std::move(header), std::move(sink), nullptr) {}

LiveRun::LiveRun(std::shared_ptr<const Scene> scene, const RunSetup& setup, TrialHeader header,
                 std::unique_ptr<TrialSink> sink, std::unique_ptr<HapticDevice> device)
    : scene_(std::move(scene)),
      pointer_(setup.start),
      device_(std::move(device)),
      commands_(kCommandsWaiting),
      samples_(std::make_unique<SpscRing<Sample>>(kRecordingRing)),
      sink_(std::move(sink)),
      loop_({.device = &this->device(),
             .scene = scene_.get(),
             .recording = samples_.get(),
             .live = &live_,
             .commands = &commands_},
            options(setup)),
      thread_(loop_, kTick_us) {
  TORSIO_EXPECTS(sink_ != nullptr);
  header.deviceModel = this->device().capabilities().model;
  header.deviceLimits = deviceLimits(this->device().capabilities());
  header.drive = setup.drive;
  header.targetAngle_rad = setup.targetAngle_rad;
  header.forceScale = options(setup).forceScale;
  header.tickPeriod_us = kTick_us;
  recorder_ = std::make_unique<Recorder>(*samples_, *sink_, std::move(header));
}

LiveRun::~LiveRun() {
  thread_.stop();
}

void LiveRun::start() {
  if (recorder_) recorder_->start();
  thread_.start();
}

std::unique_ptr<HapticDevice> LiveRun::releaseDevice() {
  thread_.stop();
  if (device_) device_->write({});
  return std::move(device_);
}

RecordingResult LiveRun::finish(TrialOutcome outcome) {
  TORSIO_EXPECTS(recorder_ != nullptr);
  thread_.stop();
  return recorder_->finish(outcome, loop_.lateTicks());
}

}  // namespace torsio::gui
