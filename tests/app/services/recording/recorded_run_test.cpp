// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of run uses the same wiring: the same header, the same recording.
#include "app/services/recording/recorded_run.h"

#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/base/build_info.h"
#include "app/services/recording/async_model_worker.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/pointer_device.h"
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

const std::shared_ptr<const Scene>& bar() {
  static const auto kBar = std::make_shared<const Scene>(barScene());
  return kBar;
}

std::unique_ptr<ScriptedHand> hand(double duration_s = 20.0) {
  ScriptedHandOptions options;
  options.task = handTask(*bar());
  options.duration_s = duration_s;
  return std::make_unique<ScriptedHand>(options);
}

RecordingSpec spec() {
  return {.trialId = "one",
          .traineeCode = "T-01",
          .phaseLabel = "virtual 0-20 min",
          .targetAngle_rad = 0.7,
          .startedUtc_us = 1'700'000'000'000'000,
          .demonstration = true};
}

TEST(HeaderFor, TakesEachValueFromItsSource) {
  DeviceCapabilities device;
  device.model = "Some stylus";
  device.maxForce_N = 2.5;
  device.drive = TwistDrive::kRoll;

  const TrialHeader header = headerFor(*bar(), device, spec());

  EXPECT_EQ(header.trialId, "one");
  EXPECT_EQ(header.traineeCode, "T-01");
  EXPECT_EQ(header.phaseLabel, "virtual 0-20 min");
  EXPECT_EQ(header.targetAngle_rad, 0.7);
  EXPECT_EQ(header.startedUtc_us, 1'700'000'000'000'000);
  EXPECT_TRUE(header.demonstration);
  EXPECT_EQ(header.sceneId, bar()->id);
  EXPECT_EQ(header.patternId, bar()->pattern.id);
  EXPECT_EQ(header.organHash, bar()->organHash);
  EXPECT_EQ(header.parameterHash, bar()->parameterHash);
  EXPECT_EQ(header.parametersJson, bar()->parametersJson);
  EXPECT_EQ(header.deviceModel, "Some stylus");
  EXPECT_EQ(header.deviceLimits.maxForce_N, 2.5);
  EXPECT_EQ(header.drive, TwistDrive::kRoll);
  EXPECT_EQ(header.softwareVersion, softwareVersion());
  EXPECT_EQ(header.tickPeriod_us, kTickPeriod_us);
}

TEST(HeaderFor, UsesTheTargetOfThePatternIfNoneIsGiven) {
  RecordingSpec free = spec();
  free.targetAngle_rad.reset();

  EXPECT_EQ(headerFor(*bar(), {}, free).targetAngle_rad, bar()->pattern.targetAngle_rad);
}

TEST(RecordedRun, HasTheSameHeaderForEveryKindOfRun) {
  const TrialHeader expected = headerFor(*bar(), hand()->capabilities(), spec());

  const auto stepped = std::make_shared<MemoryTrialSink>();
  RecordedRun(bar(), hand(), spec(), stepped).step(ticksIn(1.0));
  MemoryTrialSink scripted;
  recordScriptedTrial(*bar(), {.recording = spec(), .duration_s = 1.0}, scripted);
  const auto live = std::make_shared<MemoryTrialSink>();
  RecordedRun inRealTime(bar(), hand(), spec(), live);
  inRealTime.start();
  std::this_thread::sleep_for(50ms);
  static_cast<void>(inRealTime.finish(TrialOutcome::kCompleted));

  EXPECT_EQ(stepped->trial().header, expected);
  EXPECT_EQ(scripted.trial().header, expected);
  EXPECT_EQ(live->trial().header, expected);
  const TrialHeader expert = expertRun(*bar(), 0.7).header;
  EXPECT_EQ(
      expert,
      headerFor(
          *bar(), hand()->capabilities(),
          {.trialId = "expert", .phaseLabel = kExpertPhase, .targetAngle_rad = 0.7, .demonstration = true}));
}

TEST(RecordedRun, IsTheSameForAScriptAndForStepping) {
  const ScriptedTrial script{.recording = spec(), .duration_s = 3.0};
  MemoryTrialSink scripted;
  const TrialSummary summary = recordScriptedTrial(*bar(), script, scripted);
  ScriptedHandOptions options;
  options.seed = script.trialSeed;
  options.task = handTask(*bar());
  options.profile = handProfile(script.personSeed);
  options.duration_s = script.duration_s;

  const auto stepped = std::make_shared<MemoryTrialSink>();
  RecordedRun run(bar(), std::make_unique<ScriptedHand>(options), spec(), stepped);
  for (int i = 0; i < 3'000; ++i) {
    run.step();
  }
  const RecordingResult result = run.finish(TrialOutcome::kCompleted);

  EXPECT_EQ(summary.samples, 3'000);
  EXPECT_EQ(result.summary.contentHash, summary.contentHash);
  EXPECT_TRUE(replayTrial(*bar(), stepped->trial()).identical());
}

TEST(RecordedRun, PassesOnEachSecondAsSoonAsItIsComplete) {
  const auto kept = std::make_shared<MemoryTrialSink>();
  RecordedRun run(bar(), hand(), spec(), kept);

  run.step(999);
  EXPECT_TRUE(kept->trial().chunks.empty());
  run.step();
  EXPECT_EQ(kept->trial().chunks.size(), 1U);
}

TEST(RecordedRun, IsInterruptedUnlessFinished) {
  const auto kept = std::make_shared<MemoryTrialSink>();
  { RecordedRun(bar(), hand(), spec(), kept).step(2'500); }

  EXPECT_EQ(kept->trial().summary.outcome, TrialOutcome::kInterrupted);
  EXPECT_EQ(kept->trial().chunks.size(), 2U);
}

TEST(RecordedRun, RecordsInRealTimeUntilItIsFinished) {
  const auto kept = std::make_shared<MemoryTrialSink>();
  RecordedRun run(bar(), hand(), spec(), kept);

  run.start();
  while (run.latest().tick < 200) {
    std::this_thread::sleep_for(5ms);
  }
  const RecordingResult result = run.finish(TrialOutcome::kCompleted);

  EXPECT_GT(result.summary.samples, 200);
  EXPECT_EQ(result.summary.refusedSamples, 0);
  EXPECT_TRUE(replayTrial(*bar(), kept->trial()).identical());
}

TEST(RecordedRun, WithoutASinkRunsTheSameButStoresNothing) {
  RecordedRun run(bar(), hand(), {.targetAngle_rad = 0.4}, nullptr);

  run.step(10);

  EXPECT_FALSE(run.recorded());
  EXPECT_EQ(run.latest().tick, 9);
  EXPECT_EQ(run.latest().targetAngle_rad, 0.4);
  EXPECT_EQ(run.header().deviceModel, hand()->capabilities().model);
}

TEST(RecordedRun, AMouseTurnsOnTheSpotAndAHandMovesAround) {
  const RecordedRun mouse(bar(), std::make_unique<PointerDevice>(Pose{}), {}, nullptr);
  const RecordedRun led(bar(), hand(), {}, nullptr);

  EXPECT_EQ(mouse.header().drive, TwistDrive::kRoll);
  EXPECT_EQ(led.header().drive, TwistDrive::kTangential);
}

TEST(RecordedRun, AppliesCommandsAndReportsAFullQueue) {
  RecordedRun run(bar(), hand(), {}, nullptr);

  ASSERT_TRUE(run.command({.kind = ServoCommand::Kind::kSetTarget, .value = 0.25}));
  run.step();
  EXPECT_EQ(run.latest().targetAngle_rad, 0.25);
  int taken = 0;
  while (run.command({.kind = ServoCommand::Kind::kReleaseTissue})) {
    ++taken;
  }
  EXPECT_EQ(taken, 64);
}

/// Remembers the forces written to it.
class Motor final : public HapticDevice {
 public:
  explicit Motor(std::vector<Vec3>& forces) : forces_(&forces) {}
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t) noexcept override { return {}; }
  void write(const ForceCommand& command) noexcept override { forces_->push_back(command.force_N); }

 private:
  std::vector<Vec3>* forces_;
  DeviceCapabilities capabilities_;
};

TEST(RecordedRun, ReleasesItsDeviceWithTheForceAtZero) {
  std::vector<Vec3> forces;
  RecordedRun run(bar(), std::make_unique<Motor>(forces), {}, nullptr);
  run.step(3);

  const std::unique_ptr<HapticDevice> device = run.releaseDevice();

  ASSERT_EQ(forces.size(), 4U);
  EXPECT_EQ(forces.back(), Vec3{});
  EXPECT_NE(device, nullptr);
}

TEST(RecordedRun, RejectsADeviceWithInvalidLimits) {
  struct Broken final : HapticDevice {
    Broken() { limits.maxForce_N = -1.0; }
    [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return limits; }
    [[nodiscard]] DeviceSample read(std::int64_t) noexcept override { return {}; }
    void write(const ForceCommand&) noexcept override {}
    DeviceCapabilities limits;
  };

  EXPECT_THROW(RecordedRun(bar(), std::make_unique<Broken>(), {}, nullptr), Error);
}

// Runs with every model: recorded with the model's name and replayed bit for bit.

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
  EXPECT_EQ(fromBytes<TrialHeader>(toBytes(trial.header)), trial.header);
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
