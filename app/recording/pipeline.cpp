// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/pipeline.h"

#include <cmath>
#include <memory>

#include "app/base/build_info.h"
#include "sim/base/clock.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/recorder.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"

namespace torsio {

namespace {

constexpr std::int64_t kPumpEvery_ticks = 1000;

TrialHeader headerOf(const Scene& scene, const ScriptedTrial& trial, const HapticDevice& device) {
  TrialHeader header;
  header.trialId = trial.trialId;
  header.traineeCode = trial.traineeCode;
  header.sceneId = scene.id;
  header.patternId = scene.pattern.id;
  header.organHash = scene.organHash;
  header.parameterHash = scene.parameterHash;
  header.parametersJson = scene.parametersJson;
  header.deviceModel = device.capabilities().model;
  header.deviceLimits = deviceLimits(device.capabilities());
  header.softwareVersion = softwareVersion();
  header.phaseLabel = trial.phaseLabel;
  header.targetAngle_rad = scene.pattern.targetAngle_rad;
  header.startedUtc_us = trial.startedUtc_us;
  header.demonstration = trial.demonstration;
  return header;
}

}  // namespace

TrialSummary recordScriptedTrial(const Scene& scene, const ScriptedTrial& trial, TrialSink& sink) {
  ScriptedHandOptions hand;
  hand.seed = trial.trialSeed;
  hand.task = handTask(scene);
  hand.profile = handProfile(trial.personSeed);
  hand.practisedBefore_min = trial.practisedBefore_min;
  hand.practiceScale = trial.practiceScale;
  hand.duration_s = trial.duration_s;
  ScriptedHand device(hand);

  const TrialHeader header = headerOf(scene, trial, device);
  SpscRing<Sample> ring(kRecordingRing);
  Recorder recorder(ring, sink, header);
  ServoOptions options;
  options.drive = header.drive;
  options.targetAngle_rad = header.targetAngle_rad;
  options.forceScale = header.forceScale;
  options.tickPeriod_us = header.tickPeriod_us;
  ServoLoop::Links links;
  links.device = &device;
  links.scene = &scene;
  links.recording = &ring;
  ServoLoop servo(links, options);

  ManualClock clock;
  const auto ticks = static_cast<std::int64_t>(trial.duration_s * 1e6) / header.tickPeriod_us;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    servo.tick(clock.now_us());
    clock.advance_us(header.tickPeriod_us);
    if (tick % kPumpEvery_ticks == kPumpEvery_ticks - 1) recorder.pump();
  }
  return recorder.finish(TrialOutcome::kCompleted, servo.lateTicks()).summary;
}

}  // namespace torsio
