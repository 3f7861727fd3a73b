// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/pipeline.h"

#include <memory>

#include "app/recording/recorded_run.h"
#include "sim/base/tick_period.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"

namespace torsio {

namespace {

ScriptedHandOptions handOf(const Scene& scene, const ScriptedTrial& trial) {
  ScriptedHandOptions hand;
  hand.seed = trial.trialSeed;
  hand.task = handTask(scene);
  hand.profile = handProfile(trial.personSeed);
  hand.practisedBefore_min = trial.practisedBefore_min;
  hand.practiceScale = trial.practiceScale;
  hand.duration_s = trial.duration_s;
  return hand;
}

}  // namespace

TrialSummary recordScriptedTrial(const Scene& scene, const ScriptedTrial& trial, TrialSink& sink) {
  RecordedRun run(borrowed(scene), std::make_unique<ScriptedHand>(handOf(scene, trial)), trial.recording,
                  borrowed(sink));
  run.step(ticksIn(trial.duration_s));
  return run.finish(TrialOutcome::kCompleted).summary;
}

}  // namespace torsio
