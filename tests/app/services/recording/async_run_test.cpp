// SPDX-License-Identifier: GPL-3.0-or-later
// Runs with every model: recorded with the model's name and replayed bit for bit.
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/recording/async_model_worker.h"
#include "app/services/recording/pipeline.h"
#include "app/services/recording/recorded_run.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<const Scene> barOf(TissueModel model) {
  Scene scene = barScene();
  scene.tissue = model;
  return std::make_shared<const Scene>(std::move(scene));
}

Trial recorded(const std::shared_ptr<const Scene>& scene) {
  MemoryTrialSink sink;
  recordScriptedTrial(*scene, {.recording = {.trialId = "one"}, .duration_s = 8.0}, sink);
  return sink.trial();
}

class RunOf : public ::testing::TestWithParam<TissueModel> {};

TEST_P(RunOf, IsRecordedWithItsModelAndReplaysBitForBit) {
  const auto scene = barOf(GetParam());

  const Trial trial = recorded(scene);

  EXPECT_EQ(trial.header.model, GetParam());
  EXPECT_EQ(headerFromBytes(toBytes(trial.header)), trial.header);
  double largest_Nm = 0.0;
  std::int64_t arrived = 0;
  for (const Sample& sample : decodeTrial(trial)) {
    largest_Nm = std::max(largest_Nm, std::abs(sample.response.torque_Nm));
    arrived += sample.async.state == AsyncState::kSound ? 1 : 0;
  }
  EXPECT_GT(largest_Nm, 0.02);
  EXPECT_EQ(arrived > 0, runsAsync(GetParam()));
  const ReplayReport report = replayTrial(*scene, trial);
  EXPECT_TRUE(report.identical());
  EXPECT_EQ(report.samples, 8'000);
}

INSTANTIATE_TEST_SUITE_P(Models, RunOf, ::testing::ValuesIn(kTissueModels),
                         [](const auto& one) { return std::string(tissueModelId(one.param)); });

TEST(RunOfFiniteElements, DoesNotReplayWithoutTheRecordedModelResults) {
  const auto scene = barOf(TissueModel::kFiniteElements);
  const Trial trial = recorded(scene);
  Trial without = trial;
  without.chunks.clear();
  std::int64_t index = 0;
  for (const TrialChunk& chunk : trial.chunks) {
    std::vector<Sample> samples = decodeChunk(chunk);
    for (Sample& sample : samples) {
      sample.async = {};
    }
    without.chunks.push_back(encodeChunk(index++, samples));
  }

  EXPECT_GT(replayTrial(*scene, without).differentSamples, 100);
}

TEST(RunOfFiniteElements, InRealTimeRunsInParallelWithTheServoAndReplays) {
  const auto scene = barOf(TissueModel::kFiniteElements);
  const auto sink = std::make_shared<MemoryTrialSink>();
  const auto shape = std::make_shared<LatestShape>(*scene);
  ScriptedHandOptions options;
  options.task = handTask(*scene);
  RecordedRun run(scene, std::make_unique<ScriptedHand>(options), {.trialId = "live"}, sink, shape);
  constexpr int kFrames = 5;

  run.start();
  const auto end = std::chrono::steady_clock::now() + 60s;
  while ((run.latest().response.torque_Nm == 0.0 || shape->number() < kFrames) &&
         std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(10ms);
  }
  static_cast<void>(run.finish(TrialOutcome::kCompleted));

  EXPECT_GE(shape->number(), kFrames);
  EXPECT_NE(run.latest().response.torque_Nm, 0.0);
  EXPECT_GT(run.asyncModel()->framesPerSecond(), 0.0);
  EXPECT_TRUE(replayTrial(*scene, sink->trial()).identical());
}

/// A model controlled by the test.
class FaultyOrgan final : public GraspedOrgan {
 public:
  explicit FaultyOrgan(double torque_Nm) : torque_Nm_(torque_Nm) {}
  void turnTo(double angle_rad) override { angle_rad_ = angle_rad; }
  [[nodiscard]] double angle_rad() const override { return angle_rad_; }
  [[nodiscard]] double torque_Nm() const override { return torque_Nm_; }
  [[nodiscard]] double slope_Nm_per_rad() const override { return 0.1; }
  [[nodiscard]] LatticePlaces surface() const override { return {}; }

 private:
  double torque_Nm_;
  double angle_rad_ = 0.0;
};

TEST(AsyncModelWorker, ReportsNanAndExceptionsAsBroken) {
  AsyncLink link;
  int made = 0;
  AsyncModelWorker worker(barOf(TissueModel::kMassSpring), link, nullptr,
                          [&made](double) -> std::unique_ptr<GraspedOrgan> {
                            if (++made == 2) {
                              throw std::runtime_error("no springs");
                            }
                            const double nan = std::numeric_limits<double>::quiet_NaN();
                            return std::make_unique<FaultyOrgan>(made == 1 ? nan : 0.25);
                          });
  link.questions.publish({3, 0.2, 0.1});
  std::vector<AsyncState> states;

  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_TRUE(worker.work());
    states.push_back(link.deliveries.latest().answer.state);
  }

  EXPECT_EQ(states, (std::vector{AsyncState::kBroken, AsyncState::kBroken, AsyncState::kSound}));
  EXPECT_EQ(link.deliveries.latest().grip, 3);
  EXPECT_EQ(link.deliveries.latest().answer, (AsyncAnswer{AsyncState::kSound, 0.1, 0.25, 0.1}));
}

TEST(AsyncModelWorker, RebuildsTheModelOnlyForAnotherJawPosition) {
  AsyncLink link;
  std::vector<double> arcs;
  AsyncModelWorker worker(barOf(TissueModel::kMassSpring), link, nullptr, [&arcs](double arc_m) {
    arcs.push_back(arc_m);
    return std::make_unique<FaultyOrgan>(0.0);
  });

  for (const double arc_m : {0.200, 0.205, 0.100}) {  // section spacing is 250 mm / 12 = 21 mm
    link.questions.publish({1, arc_m, 0.0});
    static_cast<void>(worker.work());
  }

  EXPECT_EQ(arcs, (std::vector{0.200, 0.100}));
}

TEST(AsyncModelPlayback, DrawsTheModelMovedToTheRecordedAngle) {
  const auto scene = barOf(TissueModel::kFiniteElements);
  const auto shape = std::make_shared<LatestShape>(*scene);
  AsyncModelPlayback playback(scene, shape);
  LiveState shown;
  shown.response.graspArc_m = 0.2;
  shown.response.angle_rad = 0.3;

  playback.follow(shown);
  const double wanted_m = 2.0 * kBarRadius_m * std::sin(0.15);
  const auto farthest_m = [&] {
    std::vector<Vec3> vertices_m = scene->mesh.vertices_m;
    shape->vertices(vertices_m);
    double farthest = 0.0;
    for (std::size_t i = 0; i < vertices_m.size(); ++i) {
      farthest = std::max(farthest, norm(vertices_m[i] - scene->mesh.vertices_m[i]));
    }
    return farthest;
  };
  // The free end overshoots the jaw's angle before it comes to rest.
  constexpr std::int64_t kFramesToRest = 120;  // 2 s of the model
  const auto end = std::chrono::steady_clock::now() + 60s;
  while (shape->number() < kFramesToRest && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(10ms);
  }

  EXPECT_GE(shape->number(), kFramesToRest);
  EXPECT_NEAR(farthest_m(), wanted_m, 1e-3);
}

}  // namespace
}  // namespace torsio
