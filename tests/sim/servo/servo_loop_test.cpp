// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_loop.h"

#include <cfenv>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/device/virtual/virtual_drivers.h"
#include "sim/record/recorder.h"
#include "sim/record/trial.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/support/allocation_count.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

const Scene& loopScene() {
  static const Scene kScene = barScene();
  return kScene;
}

ScriptedHand trainee(std::uint64_t seed, double duration_s) {
  return ScriptedHand(
      {.seed = seed, .task = handTask(loopScene()), .profile = handProfile(seed), .duration_s = duration_s});
}

struct Recording {
  Trial trial;
  std::vector<Sample> exact;
};

TrialHeader headerFor(const HapticDevice& device, const ServoOptions& options) {
  TrialHeader header;
  header.trialId = "test";
  header.organHash = loopScene().organHash;
  header.parameterHash = loopScene().parameterHash;
  header.deviceModel = device.capabilities().model;
  header.deviceLimits = deviceLimits(device.capabilities());
  header.drive = options.drive;
  header.targetAngle_rad = options.targetAngle_rad;
  header.forceScale = options.forceScale;
  header.tickPeriod_us = options.tickPeriod_us;
  return header;
}

/// Plays the device for so many ticks on a manual clock; ticks jitter by a few microseconds. `commands` are
/// pushed every half second in turn.
Recording record(HapticDevice& device, const ServoOptions& options, int ticks,
                 const std::vector<ServoCommand>& commands = {}) {
  Recording recording;
  MemoryTrialSink sink;
  SpscRing<Sample> ring(kRecordingRing);
  SpscRing<ServoCommand> wishes(16);
  ServoLoop loop({.device = &device, .scene = &loopScene(), .recording = &ring, .commands = &wishes},
                 options);
  Recorder recorder(ring, sink, headerFor(device, options));
  std::size_t nextCommand = 0;
  for (int i = 0; i < ticks; ++i) {
    if (i % 500 == 499 && nextCommand < commands.size()) {
      EXPECT_TRUE(wishes.push(commands[nextCommand++]));
    }
    loop.tick(1000LL * i + (i * 31) % 17);
    recording.exact.push_back(loop.lastSample());
    if (i % 1000 == 999) {
      recorder.pump();
    }
  }
  (void)recorder.finish(TrialOutcome::kCompleted, loop.lateTicks());
  recording.trial = sink.trial();
  return recording;
}

TEST(ServoLoop, TakesAScriptedHandThroughAllPhasesOfAnExercise) {
  ScriptedHand hand = trainee(3, 20.0);
  const Recording recording = record(hand, {}, 20'000);

  std::vector<ExercisePhase> phases;
  double largest_rad = 0.0;
  double largest_N = 0.0;
  for (const Sample& sample : recording.exact) {
    if (phases.empty() || phases.back() != sample.phase) {
      phases.push_back(sample.phase);
    }
    largest_rad = std::max(largest_rad, sample.response.angle_rad);
    largest_N = std::max(largest_N, norm(sample.force_N));
  }

  ASSERT_GE(phases.size(), 5U);
  EXPECT_EQ(phases[0], ExercisePhase::kTracking);
  EXPECT_EQ(phases[1], ExercisePhase::kContact);
  const std::set<ExercisePhase> seen(phases.begin(), phases.end());
  EXPECT_EQ(seen.size(), 4U);
  EXPECT_EQ(phases.back(), ExercisePhase::kTracking);
  EXPECT_NEAR(largest_rad, radians(90.0), radians(35.0));
  EXPECT_GT(largest_N, 0.5);
  EXPECT_LE(largest_N, 3.3 + 1e-9);
}

TEST(ServoLoop, SendsNoForceOutOfContactOnceTheContactForceHasFaded) {
  ScriptedHand hand = trainee(5, 20.0);
  int quiet = 0;
  for (const Sample& sample : record(hand, {}, 20'000).exact) {
    quiet = sample.phase == ExercisePhase::kTracking ? quiet + 1 : 0;
    // 3.3 N fall at 0.1 N a tick.
    ASSERT_TRUE(quiet <= 40 || sample.force_N == Vec3{}) << "tick " << sample.tick;
  }
}

TEST(ServoLoop, ReplaysBitForBitWithBothDrives) {
  for (const TwistDrive drive : {TwistDrive::kTangential, TwistDrive::kRoll}) {
    ScriptedHand hand = trainee(11, 15.0);
    const Recording recording =
        record(hand, {.drive = drive, .targetAngle_rad = 1.5, .forceScale = 0.8}, 15'500);

    const ReplayReport report = replayTrial(loopScene(), recording.trial);

    EXPECT_TRUE(report.identical());
    EXPECT_EQ(report.samples, 15'500);
    EXPECT_EQ(report.chunks, 16);
    EXPECT_FALSE(report.first.has_value());
  }
}

TEST(ServoLoop, RecordsTheCommandsItObeysSoThatTheyReplay) {
  using Kind = ServoCommand::Kind;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  ScriptedHand hand = trainee(11, 15.0);
  const Recording recording = record(hand, {}, 12'000,
                                     {{Kind::kSetForceScale, 0.5},
                                      {Kind::kSetForceScale, 7.0},  // out of range: ignored
                                      {Kind::kSetTarget, kNan},     // ignored
                                      {Kind::kSetTarget, 2.0},
                                      {Kind::kEnableForce, 0.0},
                                      {Kind::kEnableForce, 1.0},
                                      {Kind::kReleaseTissue, 0.0},
                                      {Kind::kReleaseTissue, 0.0},
                                      {Kind::kReleaseTissue, 0.0},
                                      {Kind::kReleaseTissue, 0.0},
                                      {Kind::kReleaseTissue, 0.0},
                                      {Kind::kReleaseTissue, 0.0}});
  int obeyed = 0;
  for (const Sample& sample : recording.exact) {
    obeyed += sample.command.kind == Kind::kNone ? 0 : 1;
    ASSERT_TRUE(std::isfinite(sample.command.value));
  }

  EXPECT_EQ(obeyed, 10);
  EXPECT_TRUE(replayTrial(loopScene(), recording.trial).identical());
}

TEST(ServoLoop, ReleasesTheTissueOnCommand) {
  ScriptedHand hand = trainee(11, 15.0);
  std::vector<ServoCommand> commands(12, ServoCommand{ServoCommand::Kind::kReleaseTissue, 0.0});
  for (const Sample& sample : record(hand, {}, 6'000, commands).exact) {
    if (sample.command.kind == ServoCommand::Kind::kReleaseTissue) {
      ASSERT_NE(sample.phase, ExercisePhase::kTwisting);
    }
  }
}

/// Encodes the trial anew after `change` was made to sample `tick` of what was decoded.
template <typename Change>
Trial tampered(const Trial& trial, std::int64_t tick, Change change) {
  Trial copy = trial;
  std::vector<Sample> samples = decodeChunk(copy.chunks[static_cast<std::size_t>(tick / 1000)]);
  const std::string exact = copy.chunks[static_cast<std::size_t>(tick / 1000)].outputDigest;
  change(samples[static_cast<std::size_t>(tick % 1000)]);
  TrialChunk& chunk = copy.chunks[static_cast<std::size_t>(tick / 1000)];
  chunk = encodeChunk(tick / 1000, samples);
  chunk.outputDigest = exact;
  copy.summary.contentHash = contentHash(copy);
  return copy;
}

TEST(ReplayTrial, NamesTheFirstTickAndFieldThatDiffers) {
  ScriptedHand hand = trainee(11, 15.0);
  const Recording recording = record(hand, {}, 8'000);
  ASSERT_EQ(recording.exact[4'321].phase, ExercisePhase::kTwisting);

  const ReplayReport otherAnswer = replayTrial(
      loopScene(), tampered(recording.trial, 4'321, [](Sample& s) { s.response.torque_Nm += 1e-5; }));
  const ReplayReport otherInput = replayTrial(
      loopScene(), tampered(recording.trial, 4'321, [](Sample& s) { s.device.position[1] += 100; }));

  ASSERT_TRUE(otherAnswer.first.has_value());
  EXPECT_EQ(otherAnswer.first->tick, 4'321);
  EXPECT_EQ(otherAnswer.first->field, "torque");
  EXPECT_NEAR(otherAnswer.first->recorded - otherAnswer.first->replayed, 1e-5, 1e-9);
  EXPECT_EQ(otherAnswer.differentSamples, 1);
  EXPECT_EQ(otherAnswer.differentChunks, 0);
  EXPECT_FALSE(otherAnswer.identical());
  ASSERT_TRUE(otherInput.first.has_value());
  EXPECT_EQ(otherInput.first->tick, 4'321);
  EXPECT_GE(otherInput.differentChunks, 1);
}

TEST(ReplayTrial, SeesADifferenceInTheLastBitOfAnAnswer) {
  ScriptedHand hand = trainee(11, 15.0);
  Recording recording = record(hand, {}, 8'000);
  std::vector<Sample> second(recording.exact.begin() + 4'000, recording.exact.begin() + 5'000);
  second[321].response.torque_Nm = std::nextafter(second[321].response.torque_Nm, 1.0);
  recording.trial.chunks[4] = encodeChunk(4, second);
  recording.trial.summary.contentHash = contentHash(recording.trial);

  const ReplayReport report = replayTrial(loopScene(), recording.trial);

  EXPECT_EQ(report.differentSamples, 0);
  EXPECT_EQ(report.differentChunks, 1);
  ASSERT_TRUE(report.first.has_value());
  EXPECT_EQ(report.first->tick, 4'000);
  EXPECT_EQ(report.first->field, "exact answers");
}

TEST(ReplayTrial, StopsAtAGapThatAFullRingLeft) {
  IdleDevice device(Pose{{0.2, 0.0, 0.1}, {}});
  SpscRing<Sample> ring(700);
  MemoryTrialSink sink;
  ServoLoop loop({.device = &device, .scene = &loopScene(), .recording = &ring}, {});
  Recorder recorder(ring, sink, headerFor(device, {}));
  for (int i = 0; i < 1'000; ++i) {
    loop.tick(1000LL * i);
  }
  recorder.pump();
  for (int i = 1'000; i < 1'500; ++i) {
    loop.tick(1000LL * i);
  }
  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, 0);

  const ReplayReport report = replayTrial(loopScene(), sink.trial());

  EXPECT_EQ(result.summary.refusedSamples, 300);
  EXPECT_EQ(report.samples, 700);
  ASSERT_TRUE(report.gapAfterTick.has_value());
  EXPECT_EQ(*report.gapAfterTick, 699);
  EXPECT_FALSE(report.identical());
}

TEST(ReplayTrial, RefusesAnotherSceneAndReportsABrokenSeal) {
  IdleDevice device(Pose{{0.2, 0.0, 0.1}, {}});
  Recording recording = record(device, {}, 100);
  Trial otherOrgan = recording.trial;
  otherOrgan.header.organHash = "another";
  Trial otherParameters = recording.trial;
  otherParameters.header.parameterHash = "other";
  Trial otherTrainee = recording.trial;
  otherTrainee.header.traineeCode = "somebody else";

  for (const Trial& bad : {otherOrgan, otherParameters}) {
    EXPECT_EQ(testing::refusal([&] { return replayTrial(loopScene(), bad); }).code(),
              ErrorCode::kVerifyFailed);
  }
  EXPECT_FALSE(replayTrial(loopScene(), otherTrainee).contentIntact);
  EXPECT_FALSE(replayTrial(loopScene(), otherTrainee).identical());
}

TEST(ServoLoop, TakesNoMemoryInATick) {
  ScriptedHand hand = trainee(3, 10.0);
  SpscRing<Sample> ring(20'000);
  SpscRing<ServoCommand> wishes(4);
  LatestValue<LiveState> live;
  ServoLoop loop(
      {.device = &hand, .scene = &loopScene(), .recording = &ring, .live = &live, .commands = &wishes}, {});
  ASSERT_TRUE(wishes.push({ServoCommand::Kind::kSetTarget, 1.0}));

  const std::int64_t before = testing::allocationCount();
  for (int i = 0; i < 10'000; ++i) {
    loop.tick(1000LL * i);
  }
  const std::int64_t taken = testing::allocationCount() - before;

  EXPECT_EQ(taken, 0);
  EXPECT_EQ(loop.ticks(), 10'000);
}

TEST(ServoLoop, CountsLateTicksAndCutsTheForceAfterAGap) {
  ScriptedHand hand = trainee(3, 20.0);
  ServoLoop loop({.device = &hand, .scene = &loopScene()}, {});
  std::int64_t time_us = 0;
  double before_N = 0.0;
  while (before_N < 1.0 && time_us < 10'000'000) {
    loop.tick(time_us += 1000);
    before_N = norm(loop.lastSample().force_N);
  }
  ASSERT_GE(before_N, 1.0);
  const std::int64_t inTime = loop.lateTicks();

  loop.tick(time_us += 20'000);

  EXPECT_EQ(inTime, 0);
  EXPECT_EQ(loop.lateTicks(), 19);
  EXPECT_EQ(loop.lastSample().force_N, Vec3{});
  EXPECT_EQ(loop.governorState(), GovernorState::kEngaging);
}

TEST(ServoLoop, PublishesWhatItRecords) {
  ScriptedHand hand = trainee(3, 20.0);
  LatestValue<LiveState> live;
  ServoLoop loop({.device = &hand, .scene = &loopScene(), .live = &live}, {.targetAngle_rad = 1.25});
  for (int i = 0; i < 4'000; ++i) {
    loop.tick(1000LL * i);
  }

  const LiveState state = live.latest();

  EXPECT_EQ(state.tick, 3'999);
  EXPECT_EQ(state.time_us, 3'999'000);
  EXPECT_EQ(state.phase, loop.lastSample().phase);
  EXPECT_EQ(state.response, loop.lastSample().response);
  EXPECT_EQ(state.force_N, loop.lastSample().force_N);
  EXPECT_EQ(state.targetAngle_rad, 1.25);
  EXPECT_GT(state.tickDuration_us, 0.0);
}

/// Says nothing but nonsense.
class BrokenDevice final : public HapticDevice {
 public:
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t) noexcept override {
    DeviceReading reading;
    reading.pose.position_m.x = std::numeric_limits<double>::quiet_NaN();
    return quantize(reading, {});
  }
  void write(const ForceCommand& command) noexcept override { written = command; }
  DeviceCapabilities capabilities_;
  ForceCommand written{{1.0, 0.0, 0.0}, 0};
};

TEST(ServoLoop, SendsZeroForceToADeviceThatDeliversNoPose) {
  BrokenDevice device;
  ServoLoop loop({.device = &device, .scene = &loopScene()}, {});

  for (int i = 0; i < 2'000; ++i) {
    loop.tick(1000LL * i);
    ASSERT_EQ(device.written.force_N, Vec3{});
    ASSERT_TRUE(device.written.limits & kForceInhibited);
  }
}

TEST(ServoLoop, RefusesOptionsOutOfRange) {
  IdleDevice device(Pose{});
  EXPECT_THROW(ServoLoop({.device = &device, .scene = &loopScene()}, {.forceScale = 1.5}), Error);
  EXPECT_THROW(ServoLoop({.device = &device, .scene = &loopScene()}, {.targetAngle_rad = std::nan("")}),
               Error);
}

TEST(HandTask, GraspsTheSectionOfThePatternFromOutside) {
  const HandTask task = handTask(loopScene());

  EXPECT_NEAR(std::hypot(task.graspPoint_m.x, task.graspPoint_m.y), kBarRadius_m, 1e-4);
  EXPECT_NEAR(task.graspPoint_m.z, 0.8 * kBarLength_m, 1e-6);
  EXPECT_NEAR(std::abs(task.axisDirection.z), 1.0, 1e-9);
  EXPECT_NEAR(std::hypot(task.start_m.x, task.start_m.y), kBarRadius_m + 0.090, 1e-4);
  EXPECT_EQ(task.targetAngle_rad, radians(90.0));
}

TEST(ServoLoop, DoesNotDependOnTheThreadsRoundingMode) {
  ScriptedHand first = trainee(3, 4.0);
  ScriptedHand second = trainee(3, 4.0);
  const Recording usual = record(first, {}, 3'000);

  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  const Recording upward = record(second, {}, 3'000);
  const int after = std::fegetround();
  ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);

  EXPECT_EQ(after, FE_UPWARD);  // the thread's own, for what else it does
  ASSERT_EQ(usual.exact.size(), upward.exact.size());
  for (std::size_t i = 0; i < usual.exact.size(); ++i) {
    ASSERT_EQ(usual.exact[i].force_N, upward.exact[i].force_N) << i;
    ASSERT_EQ(usual.exact[i].response, upward.exact[i].response) << i;
  }
}

}  // namespace
}  // namespace torsio
