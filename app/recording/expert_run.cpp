// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/expert_run.h"

#include "app/base/build_info.h"
#include "sim/base/clock.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/memory_trial_sink.h"
#include "sim/record/recorder.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"

namespace torsio {

namespace {

constexpr double kLongestPlan_s = 30.0;
constexpr double kAfterwards_s = 0.3;  // the organ comes to rest
constexpr std::int64_t kPumpEvery_ticks = 1000;
constexpr HandProfile kNothingLeftToLearn{
    .initialSkill = 1.0, .finalSkill = 1.0, .learningTime_min = 1.0, .tremorFrequency_Hz = 10.0};

ScriptedHandOptions expertHand(const Scene& scene, double target_rad, double duration_s) {
  ScriptedHandOptions hand;
  hand.task = handTask(scene);
  hand.task.targetAngle_rad = target_rad;
  hand.profile = kNothingLeftToLearn;
  hand.duration_s = duration_s;
  return hand;
}

}  // namespace

Trial expertRun(const Scene& scene, double target_rad) {
  const double twist_s = ScriptedHand(expertHand(scene, target_rad, kLongestPlan_s)).span_s(0)[1];
  ScriptedHand device(expertHand(scene, target_rad, kLongestPlan_s));

  TrialHeader header;
  header.trialId = "expert";
  header.sceneId = scene.id;
  header.patternId = scene.pattern.id;
  header.organHash = scene.organHash;
  header.parameterHash = scene.parameterHash;
  header.parametersJson = scene.parametersJson;
  header.deviceModel = device.capabilities().model;
  header.deviceLimits = deviceLimits(device.capabilities());
  header.softwareVersion = softwareVersion();
  header.phaseLabel = kExpertPhase;
  header.targetAngle_rad = target_rad;
  header.demonstration = true;

  MemoryTrialSink sink;
  SpscRing<Sample> ring(kRecordingRing);
  Recorder recorder(ring, sink, header);
  ServoOptions options;
  options.drive = header.drive;
  options.targetAngle_rad = target_rad;
  options.tickPeriod_us = header.tickPeriod_us;
  ServoLoop servo({.device = &device, .scene = &scene, .recording = &ring}, options);
  const auto ticks = static_cast<std::int64_t>((twist_s + kAfterwards_s) * 1e6) / header.tickPeriod_us;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    servo.tick(tick * header.tickPeriod_us);
    if (tick % kPumpEvery_ticks == kPumpEvery_ticks - 1) recorder.pump();
  }
  static_cast<void>(recorder.finish(TrialOutcome::kCompleted, servo.lateTicks()));
  return sink.trial();
}

}  // namespace torsio
