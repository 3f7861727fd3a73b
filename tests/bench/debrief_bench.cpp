// SPDX-License-Identifier: GPL-3.0-or-later
// The debrief of a long run, from the stored chunks to strengths and weaknesses, including the expert's run.
// The run is made with a manual clock. Prints one line per length and fails if a debrief takes longer than
// the five seconds promised to trainees.
#include <cstdio>
#include <ctime>

#include "app/services/recording/recorded_run.h"
#include "app/services/training/debrief.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial.h"
#include "sim/servo/hand_task.h"
#include "tests/support/shipped_scene.h"

namespace {

using namespace torsio;

constexpr double kPromise_s = 5.0;

Trial longRun(const Scene& scene, std::int64_t minutes) {
  ScriptedHandOptions hand;
  hand.task = handTask(scene);
  hand.duration_s = static_cast<double>(minutes) * 60.0;
  MemoryTrialSink sink;
  RecordedRun run(borrowed(scene), std::make_unique<ScriptedHand>(hand), {.trialId = "bench"},
                  borrowed<TrialSink>(sink));
  run.step(ticksIn(hand.duration_s));
  static_cast<void>(run.finish(TrialOutcome::kCompleted));
  return sink.trial();
}

/// Processor time, so that other load does not count.
double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

int main() {
  SceneRequest request = torsio::testing::shippedRequest("forearm");
  const Scene scene = loadScene(request);
  bool kept = true;
  for (const std::int64_t minutes : {20, 40}) {
    const Trial trial = longRun(scene, minutes);
    const AttemptRules rules{.tolerance_rad = scene.pattern.tolerance_rad};
    const double begun = processor_s();
    const std::vector<Sample> samples = decodeTrial(trial);
    const double decoded = processor_s();
    const MeasuredTrial measured = measureTwists(trial.header, samples, rules);
    const AttemptMeasures measures = measureAttempt(measured);
    const double counted = processor_s();
    const Scene again = loadScene(request);  // nothing is cached after a restart of the program
    const Trial expert = expertRun(again, trial.header.targetAngle_rad);
    const double shown = processor_s();
    const Debrief debrief = makeDebrief(trial.header, samples, measured, rules, &expert);
    const double done = processor_s();
    std::printf(
        "%2lld min, %lld twists: decode %.2f s, measure %.2f s, expert %.2f s, judge %.2f s, all %.2f s\n",
        static_cast<long long>(minutes), static_cast<long long>(measures.twists.size()), decoded - begun,
        counted - decoded, shown - counted, done - shown, done - begun);
    kept = kept && done - begun < kPromise_s && !debrief.twists.empty();
  }
  return kept ? 0 : 1;
}
