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

#include <algorithm>
#include <memory>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/trial.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/detorsion.h"
#include "sim/servo/hand_task.h"

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

namespace {

/// Returns the task of untwisting this trial's organ with this hand's habits.
HandTask untwistingOf(const Scene& scene, const ScriptedTrial& trial) {
  HandTask task = detorseTask(scene, detorsionSeed(trial.recording.trialId));
  const std::size_t leftOut = std::min(trial.turnsLeftOut, task.turns.size() - 1);
  task.turns.resize(task.turns.size() - leftOut);
  task.closure = trial.closure.value_or(task.closure);
  return task;
}

ScriptedHandOptions handOf(const Scene& scene, const ScriptedTrial& trial) {
  ScriptedHandOptions hand;
  hand.seed = trial.trialSeed;
  hand.task = scene.comesTwisted() ? untwistingOf(scene, trial) : handTask(scene);
  hand.profile = handProfile(trial.personSeed);
  hand.practisedBefore_min = trial.practisedBefore_min;
  hand.practiceScale = trial.practiceScale;
  hand.duration_s = trial.duration_s;
  return hand;
}

/// Lengthens the trial by ten percent at a time until the plan contains enough twists.
void lengthen(ScriptedHandOptions& hand, std::size_t fewestTwists) {
  constexpr double kLonger = 1.1;
  constexpr double kLongest_s = 3600.0;
  const double practice = hand.practiceScale * hand.duration_s;
  while (hand.duration_s < kLongest_s && ScriptedHand(hand).cycles() < fewestTwists) {
    hand.duration_s *= kLonger;
    hand.practiceScale = practice / hand.duration_s;
  }
}

}  // namespace

TrialSummary recordScriptedTrial(const Scene& scene, const ScriptedTrial& trial, TrialSink& sink) {
  ScriptedHandOptions hand = handOf(scene, trial);
  if (scene.hollow) {
    hand.duration_s = std::max(hand.duration_s, undone_s(*scene.hollow, ScriptedHand(hand)));
  } else {
    lengthen(hand, trial.fewestTwists);
  }
  RecordedRun run(borrowed(scene), std::make_unique<ScriptedHand>(hand), trial.recording, borrowed(sink));
  run.step(ticksIn(hand.duration_s));
  return run.finish(TrialOutcome::kCompleted).summary;
}

namespace {

constexpr double kLongestPlan_s = 30.0;
constexpr double kAfterwards_s = 0.3;  // time for the organ to come to rest
constexpr HandProfile kNothingLeftToLearn{
    .initialSkill = 1.0, .finalSkill = 1.0, .learningTime_min = 1.0, .tremorFrequency_Hz = 10.0};

ScriptedHandOptions expertHand(const Scene& scene, double target_rad) {
  ScriptedHandOptions hand;
  hand.task =
      scene.comesTwisted() ? detorseTask(scene, detorsionSeed("expert")) : handTask(scene, target_rad);
  hand.profile = kNothingLeftToLearn;
  hand.duration_s = kLongestPlan_s;
  return hand;
}

}  // namespace

Trial expertRun(const Scene& scene, double target_rad) {
  ScriptedHandOptions options = expertHand(scene, target_rad);
  auto hand = std::make_unique<ScriptedHand>(options);
  double ends_s = hand->span_s(0)[1] + kAfterwards_s;
  if (scene.hollow) {
    ends_s = undone_s(*scene.hollow, *hand);
    options.duration_s = ends_s + kAfterwards_s;
    hand = std::make_unique<ScriptedHand>(options);
  }
  const RecordingSpec spec{
      .trialId = "expert", .phaseLabel = kExpertPhase, .targetAngle_rad = target_rad, .demonstration = true};
  MemoryTrialSink sink;
  RecordedRun run(borrowed(scene), std::move(hand), spec, borrowed<TrialSink>(sink));
  run.step(ticksIn(ends_s));
  static_cast<void>(run.finish(TrialOutcome::kCompleted));
  return sink.trial();
}

}  // namespace torsio
