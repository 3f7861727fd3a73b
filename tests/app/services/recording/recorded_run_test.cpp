// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of run uses the same wiring: the same header, the same recording.
#include "app/services/recording/recorded_run.h"

#include <chrono>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/base/build_info.h"
#include "app/services/recording/pipeline.h"
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

}  // namespace
}  // namespace torsio
