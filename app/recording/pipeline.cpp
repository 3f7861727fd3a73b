// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/pipeline.h"

#include <algorithm>
#include <memory>

#include "app/recording/recorded_run.h"
#include "sim/base/tick_period.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/detorsion.h"
#include "sim/servo/hand_task.h"

namespace torsio {

namespace {

ScriptedHandOptions handOf(const Scene& scene, const ScriptedTrial& trial) {
  ScriptedHandOptions hand;
  hand.seed = trial.trialSeed;
  hand.task = scene.hollow ? detorseTask(scene, detorsionSeed(trial.recording.trialId)) : handTask(scene);
  hand.profile = handProfile(trial.personSeed);
  hand.practisedBefore_min = trial.practisedBefore_min;
  hand.practiceScale = trial.practiceScale;
  hand.duration_s = trial.duration_s;
  return hand;
}

}  // namespace

TrialSummary recordScriptedTrial(const Scene& scene, const ScriptedTrial& trial, TrialSink& sink) {
  ScriptedHandOptions hand = handOf(scene, trial);
  if (scene.hollow) {
    hand.duration_s = std::max(hand.duration_s, undone_s(*scene.hollow, ScriptedHand(hand)));
  }
  RecordedRun run(borrowed(scene), std::make_unique<ScriptedHand>(hand), trial.recording, borrowed(sink));
  run.step(ticksIn(hand.duration_s));
  return run.finish(TrialOutcome::kCompleted).summary;
}

}  // namespace torsio
