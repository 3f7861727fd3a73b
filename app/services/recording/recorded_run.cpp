// SPDX-License-Identifier: GPL-3.0-or-later
// The whole flow of Torsio, and where to read on:
//
//   device -> servo -> tissue -> recorder -> database -> assessment -> report
//   \_______________ wired here _______________/
//
//   device      a stylus, a mouse or a scripted hand says where the instrument is (sim/device)
//   servo       each millisecond: collide, step the tissue, govern the force (sim/servo/servo_loop.cpp)
//   tissue      answers angle and place of the jaw with torque and force (sim/tissue)
//   beside      a model that takes longer than a tick delivers torque and slope (async_model_worker.h)
//   recorder    packs what happened, second by second (sim/record/recorder.cpp)
//   database    a sink takes header, chunks and summary (unstored_trials.h, db/repository)
//   assessment  reads a stored trial: twists, metrics, marks, statistics (assessment)
//   report      lays the results out (app/outputs/report, app/outputs/pdf)
//
// Between the threads there are only rings and a snapshot: the servo never waits for a disk or for a window.
#include "app/services/recording/recorded_run.h"

#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/tick_period.h"

namespace torsio {

namespace {

constexpr std::size_t kCommandsWaiting = 64;
constexpr std::int64_t kPumpEvery_us = 1'000'000;  // well within what the ring of the recording holds

constexpr std::int64_t kTicksOfAFrame = 17;  // of an asynchronous model, in the time of step()

/// A hand leads the instrument now: it is held at the surface.
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

/// The servo reads the device, asks the tissue of the scene, and tells the recorder and the window.
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
