// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "app/services/recording/kept_digests.h"
#include "app/services/recording/recorded_run.h"
#include "sim/core/staged_turn.h"
#include "sim/record/sample_codec.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_parameters.h"
#include "sim/servo/pose_track.h"

namespace torsio {
namespace {

Detorsion sigmoid() {
  Detorsion detorsion;
  detorsion.wall.thickness_m = {{0.0, 0.002}};
  detorsion.wall.vent = true;
  detorsion.spans = {{0.0, 0.4}};
  detorsion.vessels.enoughFlow = 0.45;
  detorsion.base.relapseFrom_rad = 1.25;
  detorsion.limits = {.jawArea_m2 = 20e-6,
                      .jawForce_N = 8.0,
                      .bruise_Pa = 300e3,
                      .tear_Pa = 600e3,
                      .pull_N = 9.0,
                      .residual_rad = 0.25,
                      .patency = 0.7,
                      .flow = 0.75,
                      .handsOff_s = 12.0,
                      .source = "made up"};
  detorsion.timeScale = 30.0;
  return detorsion;
}

/// Returns the parameters stored by a trial with this pattern.
std::string storedWith(const std::shared_ptr<const Detorsion>& detorsion) {
  TwistPattern pattern;
  pattern.id = "detorse";
  pattern.detorsion = detorsion;
  return parametersText(SceneDescription{}, pattern, false, TissueModel::kTwist);
}

TEST(DetorsionRules, AreReadFromTheStoredParameters) {
  const std::string stored = storedWith(std::make_shared<const Detorsion>(sigmoid()));

  const std::optional<DetorsionRules> rules = detorsionRulesOf(stored);

  ASSERT_TRUE(rules);
  EXPECT_EQ(*rules, (DetorsionRules{.residual_rad = 0.25,
                                    .patency = 0.7,
                                    .flow = 0.75,
                                    .handsOff_s = 12.0,
                                    .enoughFlow = 0.45,
                                    .relapseFrom_rad = 1.25,
                                    .jaw_Pa = 8.0 / 20e-6,
                                    .bruise_Pa = 300e3,
                                    .tear_Pa = 600e3,
                                    .pull_N = 9.0,
                                    .timeScale = 30.0,
                                    .vent = true}));
}

TEST(DetorsionRules, ASolidCordHasNothingToLetOut) {
  Detorsion testis = sigmoid();
  testis.wall = {};
  testis.cordStiffness_Nm_per_rad = 0.01;

  const auto rules = detorsionRulesOf(storedWith(std::make_shared<const Detorsion>(testis)));

  ASSERT_TRUE(rules);
  EXPECT_FALSE(rules->vent);
}

TEST(DetorsionRules, ContainTheStagesOfTheScene) {
  Detorsion staged = sigmoid();
  staged.stages = {radians(360.0), 300.0};

  const auto rules = detorsionRulesOf(storedWith(std::make_shared<const Detorsion>(staged)));

  ASSERT_TRUE(rules);
  EXPECT_EQ(rules->stages, staged.stages);
}

TEST(DetorsionRules, AreEmptyForATwistAndForUnknownParameters) {
  EXPECT_FALSE(detorsionRulesOf(storedWith(nullptr)));
  EXPECT_FALSE(detorsionRulesOf("{\"detorsion\": {\"limits\": {}}}"));
  EXPECT_FALSE(detorsionRulesOf("not JSON"));
}

TEST(DetorsionRules, AreAddedToThoseOfTheExercise) {
  TrialHeader header;
  header.parametersJson = storedWith(std::make_shared<const Detorsion>(sigmoid()));

  const AttemptRules rules = recordedRules({.tolerance_rad = 0.3, .forceLimit_N = 4.0}, header);

  EXPECT_EQ(rules.tolerance_rad, 0.3);
  EXPECT_EQ(rules.forceLimit_N, 4.0);
  ASSERT_TRUE(rules.detorsion);
  EXPECT_EQ(rules.detorsion->handsOff_s, 12.0);
}

// The expert that trainees are compared with untwists every shipped organ without injury.

class ExpertDetorsion : public ::testing::TestWithParam<const char*> {};

TEST_P(ExpertDetorsion, SucceedsWithoutInjury) {
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = GetParam();
  request.pattern = "detorse";
  const Scene scene = loadScene(request);

  const Trial trial = expertRun(scene, 0.0);

  const PoseTrack track(scene, trial.header, trial.chunks);
  const HollowPose pose = track.hollowAt(std::numeric_limits<std::int64_t>::max());
  const Sample last = decodeChunk(trial.chunks.back()).back();
  const DetorsionLimits& limits = scene.hollow->detorsion().limits;
  EXPECT_EQ(pose.markCount, 0);
  EXPECT_FALSE(pose.leaking);
  EXPECT_LE(std::abs(last.response.angle_rad), limits.residual_rad);
  EXPECT_GE(last.hollow.flow, limits.flow);
  EXPECT_GE(last.hollow.patency, limits.patency);
  StagedTurn staged(scene.hollow->detorsion().stages, scene.hollow->detorsion().timeScale);
  std::int64_t ticks = 0;
  for (const TrialChunk& chunk : trial.chunks) {
    for (const Sample& sample : decodeChunk(chunk)) {
      staged.take(1e-3 * static_cast<double>(ticks++), sample.response.angle_rad);
    }
  }
  if (scene.hollow->detorsion().stages.asked()) {
    EXPECT_LE(staged.longest_rad(), scene.hollow->detorsion().stages.turn_rad + kStageTolerance_rad);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, ExpertDetorsion,
                         ::testing::Values("small-bowel-loop", "gastric-organo-axial",
                                           "gastric-mesentero-axial", "sigmoid", "midgut", "testis"));

}  // namespace
}  // namespace torsio
