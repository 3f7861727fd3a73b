// SPDX-License-Identifier: GPL-3.0-or-later
// The expert that trainees are compared with untwists every shipped organ without injury.
#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "app/services/recording/pipeline.h"
#include "sim/core/staged_turn.h"
#include "sim/record/sample_codec.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"
#include "sim/servo/pose_track.h"

namespace torsio {
namespace {

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
