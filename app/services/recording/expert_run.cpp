// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/expert_run.h"

#include <memory>
#include <utility>

#include "app/services/recording/recorded_run.h"
#include "sim/core/tick_period.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/trial.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/detorsion.h"
#include "sim/servo/hand_task.h"

namespace torsio {

namespace {

constexpr double kLongestPlan_s = 30.0;
constexpr double kAfterwards_s = 0.3;  // the organ comes to rest
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
