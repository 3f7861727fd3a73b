// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/pipeline.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/services/recording/recorded_run.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/trial.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/detorsion.h"
#include "sim/servo/hand_task.h"

namespace torsio {

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
