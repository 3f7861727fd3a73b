// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/sim/servo/recorded_trial.h"

#include "sim/core/portable_math.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {

namespace {

constexpr std::int64_t kSeconds = 8;
constexpr std::uint64_t kSeed = 11;
constexpr std::int64_t kStarted_us = 1'763'712'000'000'000;  // 2025-11-21 08:00 UTC

}  // namespace

const Scene& recordedBar() {
  static const Scene kScene = [] {
    testing::Outline2 circle;
    for (int i = 0; i < 72; ++i) {
      const SinCos at = portableSinCos(2.0 * kPi * i / 72.0);
      circle.push_back({kBarRadius_m * at.cos, kBarRadius_m * at.sin});
    }
    return barScene(testing::prism(circle, kBarLength_m, 40));
  }();
  return kScene;
}

Trial recordOnBar(const TrialId& trialId, const std::string& traineeCode, TwistDrive drive) {
  const Scene& scene = recordedBar();
  ScriptedHand hand({.seed = kSeed,
                     .task = handTask(scene),
                     .profile = handProfile(kSeed),
                     .duration_s = static_cast<double>(kSeconds)});
  ServoLoop loop({.device = &hand, .scene = &scene},
                 {.drive = drive, .targetAngle_rad = scene.pattern.targetAngle_rad});
  TrialHeader header = headerOf(scene, hand);
  header.trialId = trialId;
  header.traineeCode = traineeCode;
  header.patternId = scene.pattern.id;
  header.deviceModel = hand.capabilities().model;
  header.softwareVersion = "0.1.0";
  header.drive = drive;
  header.targetAngle_rad = scene.pattern.targetAngle_rad;
  header.startedUtc_us = kStarted_us;
  return recordedTrial(loop, header, kSeconds);
}

}  // namespace torsio
