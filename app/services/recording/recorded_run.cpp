// SPDX-License-Identifier: GPL-3.0-or-later
// Data flow of Torsio, and where to read on:
//
//   device -> servo -> tissue -> recorder -> database -> assessment -> report
//   \_____________ connected here _____________/
//
//   device      a stylus, a mouse or a scripted hand provides the pose of the instrument (sim/device)
//   servo       each millisecond: detects collisions, steps the tissue, limits the force
//   (sim/servo/servo_loop.cpp) tissue      computes torque and force from angle and position of the jaw
//   (sim/tissue) async       a model that is slower than a tick delivers torque and slope
//   (async_model_worker.h) recorder    packs the samples, second by second (sim/record/recorder.cpp) database
//   a sink stores header, chunks and summary (unstored_trials.h, db/repository) assessment  evaluates stored
//   trials: twists, metrics, marks, statistics (assessment) report      presents the results
//   (app/outputs/report, app/outputs/pdf)
//
// Threads share only ring buffers and a snapshot: the servo never waits for a disk or a window.
#include "app/services/recording/recorded_run.h"

#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::size_t kCommandsWaiting = 64;
constexpr std::int64_t kPumpEvery_us = 1'000'000;  // well below the capacity of the recording's ring

constexpr std::int64_t kTicksOfAFrame = 17;  // of an asynchronous model, in the time of step()

/// A hand now guides the instrument: it is kept at the surface.
ServoOptions liveOptions(const TrialHeader& header) {
  ServoOptions options = servoOptions(header);
  options.holdsBack = true;
  return options;
}

template <typename Pointer>
Pointer present(Pointer pointer) {
  TORSIO_EXPECTS(pointer != nullptr);
  return pointer;
}

}  // namespace

RecordedRun::RecordedRun(std::shared_ptr<const Scene> scene, std::unique_ptr<HapticDevice> device,
                         const RecordingSpec& spec, std::shared_ptr<TrialSink> sink,
                         std::shared_ptr<LatestShape> shape)
    : scene_(present(std::move(scene))),
      device_(present(std::move(device))),
      header_(headerFor(*scene_, device_->capabilities(), spec)),
      commands_(kCommandsWaiting),
      samples_(sink != nullptr ? std::make_unique<SpscRing<Sample>>(kRecordingRing) : nullptr),
      asyncModel_(runsAsync(scene_->tissue)
                      ? std::make_unique<AsyncModelWorker>(scene_, asyncLink_, std::move(shape))
                      : nullptr),
      loop_(links(), liveOptions(header_)),
      sink_(std::move(sink)) {
  if (sink_ != nullptr) {
    recorder_.emplace(*samples_, *sink_, header_);
  }
}

RecordedRun::~RecordedRun() = default;

/// Connects the servo to the device, the scene's tissue, the recorder and the window.
ServoLoop::Links RecordedRun::links() noexcept {
  return {.device = device_.get(),
          .scene = scene_.get(),
          .recording = samples_.get(),
          .live = &live_,
          .commands = &commands_,
          .async = asyncModel_ ? &asyncLink_ : nullptr};
}

void RecordedRun::start() {
  TORSIO_EXPECTS(!thread_ && loop_.ticks() == 0);
  if (recorder_) {
    recorder_->start();
  }
  if (asyncModel_) {
    asyncModel_->start();
  }
  thread_.emplace(loop_, kTickPeriod_us);
  thread_->start();
}

void RecordedRun::step(std::int64_t ticks) {
  TORSIO_EXPECTS(!thread_);
  for (std::int64_t i = 0; i < ticks; ++i) {
    if (asyncModel_ && loop_.ticks() % kTicksOfAFrame == 0) {
      static_cast<void>(asyncModel_->work());
    }
    loop_.tick(clock_.now_us());
    clock_.advance_us(kTickPeriod_us);
    if (recorder_ && clock_.now_us() % kPumpEvery_us == 0) {
      recorder_->pump();
    }
  }
}

RecordingResult RecordedRun::finish(TrialOutcome outcome) {
  TORSIO_EXPECTS(recorder_.has_value());
  if (thread_) {
    thread_->stop();
  }
  return recorder_->finish(outcome, loop_.lateTicks(),
                           thread_ ? std::optional(thread_->health()) : std::nullopt);
}

std::unique_ptr<HapticDevice> RecordedRun::releaseDevice() {
  if (thread_) {
    thread_->stop();
  }
  device_->write({});
  return std::move(device_);
}

}  // namespace torsio
