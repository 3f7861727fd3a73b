// SPDX-License-Identifier: GPL-3.0-or-later
// No run passes whose tissue bore more than the limit, whatever the device could give of it. Hands by chance,
// through the whole servo; TORSIO_FORCE_RUNS says how many, TORSIO_FORCE_FROM which is the first (slices of a
// large number run one after another).
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "app/recording/expert_run.h"
#include "app/recording/recorded_run.h"
#include "app/study/curriculum_content.h"
#include "app/training/debrief.h"
#include "assessment/attempt/recorded_loads.h"
#include "sim/base/angle.h"
#include "sim/base/random.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/memory_trial_sink.h"
#include "sim/record/sample_codec.h"
#include "sim/servo/hand_task.h"
#include "tests/app/support/training_centre.h"

namespace torsio {
namespace {

using testing::trainingBar;

constexpr std::uint64_t kSeed = 20261125;
constexpr int kUsualRuns = 40;

int wanted(const char* variable, int least, int usual) {
  const char* value = std::getenv(variable);
  return value != nullptr ? std::max(least, std::atoi(value)) : usual;
}

struct RandomRun {
  Trial trial;
  AttemptRules rules;
};

/// A hand that presses by up to a centimetre more than it should.
RandomRun randomRun(std::uint64_t stream) {
  Random random = Random::forStream(kSeed, stream);
  const auto between = [&random](double low, double high) { return low + (high - low) * random.uniform(); };
  ScriptedHandOptions hand;
  hand.seed = stream + 1;
  hand.duration_s = between(6.0, 14.0);
  const double target_rad = radians(between(20.0, 100.0));
  hand.task = handTask(trainingBar(), target_rad);
  hand.task.tipRadius_m -= std::max(0.0, between(-0.005, 0.010));
  const double skill = between(0.3, 1.0);
  hand.profile = {.initialSkill = skill, .finalSkill = skill};
  RecordingSpec spec;
  spec.targetAngle_rad = target_rad;
  MemoryTrialSink sink;
  RecordedRun run(borrowed(trainingBar()), std::make_unique<ScriptedHand>(hand), spec,
                  std::shared_ptr<TrialSink>(std::shared_ptr<void>(), &sink));
  run.step(static_cast<std::int64_t>(hand.duration_s * 1000.0));
  static_cast<void>(run.finish(TrialOutcome::kCompleted));
  return {sink.trial(), {.tolerance_rad = radians(8.0), .forceLimit_N = between(1.0, 6.0)}};
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

TEST(ForceLimit, NoRunPassesWithASampleOfTissueForceAboveIt) {
  int passed = 0;
  int failedByForceAlone = 0;
  int unseenByTheDevice = 0;
  const int first = wanted("TORSIO_FORCE_FROM", 0, 0);
  const int end = first + wanted("TORSIO_FORCE_RUNS", 1, kUsualRuns);
  for (int i = first; i < end; ++i) {
    const RandomRun run = randomRun(static_cast<std::uint64_t>(i));
    const std::vector<Sample> samples = decodeTrial(run.trial);
    const double limit_N = *run.rules.forceLimit_N;
    const bool above = std::any_of(samples.begin(), samples.end(), [&](const Sample& sample) {
      return norm(sample.response.force_N) > limit_N;
    });
    const bool felt = std::any_of(samples.begin(), samples.end(),
                                  [&](const Sample& sample) { return norm(sample.force_N) > limit_N; });

    const Debrief told = makeDebrief(run.trial.header, samples, run.rules, nullptr);

    EXPECT_FALSE(told.passed && above) << "run " << i;
    // One peak on the page: of the check, of the curve below it, of what is kept.
    const TargetCheck& force = told.checks.back();
    ASSERT_EQ(force.kind, TargetCheck::Kind::kForce);
    const AttemptMeasures measures = measureAttempt(run.trial.header, samples, run.rules);
    if (force.value) {
      EXPECT_EQ(*force.value, largest(told.own.force_N)) << "run " << i;
      EXPECT_EQ(*force.value, measures.values.at(kPeakForceMetric)) << "run " << i;
      EXPECT_EQ(force.passed, !above) << "run " << i;
    }
    passed += told.passed ? 1 : 0;
    failedByForceAlone += told.checks.front().passed && !force.passed ? 1 : 0;
    unseenByTheDevice += above && !felt ? 1 : 0;
  }
  // The property says something: runs pass, and runs fail by what the device could not give.
  EXPECT_GT(passed, 0);
  EXPECT_GT(failedByForceAlone, 0);
  EXPECT_GT(unseenByTheDevice, 0);
}

// A limit that the twist itself goes beyond would fail everybody.
TEST(ForceLimit, AnExpertKeepsToTheLimitsOfEveryShippedExercise) {
  const std::filesystem::path assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  std::map<std::pair<std::string, std::string>, RecordedLoads> known;
  for (const CurriculumTemplate& shipped : curriculumTemplates(assets)) {
    for (const TrainingModule& module : shipped.content.modules) {
      const std::string target = std::to_string(module.targetAngle_rad);
      const auto [found, isNew] =
          known.try_emplace({module.sceneId + "/" + module.patternId, target}, RecordedLoads{});
      if (isNew) {
        SceneRequest request;
        request.assets = assets;
        request.id = module.sceneId;
        request.pattern = module.patternId;
        found->second = recordedLoads(decodeTrial(expertRun(loadScene(request), module.targetAngle_rad)));
      }
      const std::string where =
          shipped.id + " " + module.code + " " + module.sceneId + "/" + module.patternId;
      ASSERT_TRUE(found->second.tissueForce_N) << where;
      EXPECT_LE(*found->second.tissueForce_N, module.maxForce_N.value_or(1e9)) << where;
      EXPECT_LE(*found->second.torque_Nm, module.maxTorque_Nm.value_or(1e9)) << where;
    }
  }
}

}  // namespace
}  // namespace torsio
