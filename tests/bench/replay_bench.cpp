// SPDX-License-Identifier: GPL-3.0-or-later
// Verification of a recorded trial: speed of a replay relative to real time, in processor and wall time, per
// scene. Options: seconds of exercise (30), then scenes (forearm stomach intestine).
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/recorded_trial.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr std::uint64_t kSeed = 3;

Scene shipped(const std::string& id) {
  return testing::shippedScene(id);
}

/// Records a moderately skilled hand for this time.
Trial recorded(const Scene& scene, std::int64_t seconds) {
  ScriptedHand hand({.seed = kSeed,
                     .task = handTask(scene),
                     .profile = {.initialSkill = 0.6, .finalSkill = 0.6},
                     .duration_s = static_cast<double>(seconds)});
  TrialHeader header = headerOf(scene, hand);
  header.trialId = "00000000-0000-4000-8000-000000000003";
  header.patternId = scene.pattern.id;
  header.deviceModel = hand.capabilities().model;
  header.targetAngle_rad = scene.pattern.targetAngle_rad;
  ServoLoop loop({.device = &hand, .scene = &scene}, servoOptions(header));
  return recordedTrial(loop, header, seconds);
}

double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void measure(const std::string& id, std::int64_t seconds) {
  const Scene scene = shipped(id);
  const double begun_s = processor_s();
  const Trial trial = recorded(scene, seconds);
  const double live_s = processor_s() - begun_s;
  const double before_s = processor_s();
  const ReplayReport report = replayTrial(scene, trial, 1);
  const double spent_s = processor_s() - before_s;
  const auto started = std::chrono::steady_clock::now();
  const ReplayReport parallel = replayTrial(scene, trial);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  const auto real_s = static_cast<double>(seconds);
  std::printf("%-10s %5lld s: run %6.1fx, replay %6.1fx a core, %6.1fx by the clock on %u, %s\n", id.c_str(),
              static_cast<long long>(seconds), real_s / live_s, real_s / spent_s, real_s / wall_s,
              std::thread::hardware_concurrency(),
              report.identical() && parallel.identical() ? "identical" : "DIFFERENT");
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const long seconds = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 30;
  if (seconds < 1 || seconds > 3600) {
    std::fputs("usage: torsio_bench_replay [SECONDS of exercise, 1 to 3600] [SCENE ...]\n", stderr);
    return 2;
  }
  std::vector<std::string> scenes(argv + std::min(argc, 2), argv + argc);
  if (scenes.empty()) {
    scenes = {"forearm", "stomach", "intestine"};
  }
  for (const std::string& id : scenes) {
    torsio::measure(id, seconds);
  }
  return 0;
}
