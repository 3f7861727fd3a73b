// SPDX-License-Identifier: GPL-3.0-or-later
// A thin organ of a user's, turned on until its tissue would have to fold: the jaw lets go and says why.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/spsc_ring.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/record/recorder.h"
#include "sim/record/trial.h"
#include "sim/scene/rod_organ.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "sim/servo/servo_loop.h"
#include "sim/servo/trial_rerun.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr int kFoldTicks = 8000;

/// A tube of 16 mm, bent about 30 mm: with the antrum carried across its bend it folds before half a turn.
const Scene& thinOrgan() {
  static const Scene kScene = [] {
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "thin_organ.obj";
    writeObj(file, testing::bentTube(0.008, 0.030, 2.5, 32, 60));
    SceneRequest request = testing::shippedRequest("stomach", "mesentero-axial");
    request.organFile = file;
    return loadScene(request);
  }();
  return kScene;
}

/// What happened to a hand that turned by 150 degrees where the tissue bears 100.
struct Overdone {
  std::vector<ExerciseMoment> moments;
  std::vector<Sample> samples;
  LiveState last;
  Trial trial;
};

const Overdone& overdone() {
  static const Overdone kRun = [] {
    const Scene& scene = thinOrgan();
    HandTask task = handTask(scene);
    task.targetAngle_rad = radians(-150.0);  // the hand knows no better
    ScriptedHand hand(
        {.seed = 5, .task = task, .profile = {.initialSkill = 0.9, .finalSkill = 0.9}, .duration_s = 7.0});
    SpscRing<Sample> ring(kRecordingRing);
    SpscRing<ExerciseMoment> events(256);
    LatestValue<LiveState> live;
    MemoryTrialSink sink;
    ServoLoop loop({.device = &hand, .scene = &scene, .recording = &ring, .live = &live, .events = &events},
                   {});
    TrialHeader header;
    header.organHash = scene.organHash;
    header.parameterHash = scene.parameterHash;
    header.deviceLimits = deviceLimits(hand.capabilities());
    Recorder recorder(ring, sink, header);
    Overdone run;
    for (int i = 0; i < kFoldTicks; ++i) {
      loop.tick(1000LL * i);
      run.samples.push_back(loop.lastSample());
      if (i % 1000 == 999) {
        recorder.pump();
      }
    }
    (void)recorder.finish(TrialOutcome::kCompleted, 0);
    run.trial = sink.trial();
    run.last = live.latest();
    for (ExerciseMoment moment; events.pop(moment);) {
      run.moments.push_back(moment);
    }
    return run;
  }();
  return kRun;
}

/// The moment at which the tissue would have folded.
const ExerciseMoment* folded(const Overdone& run) {
  const auto found = std::find_if(run.moments.begin(), run.moments.end(), [](const ExerciseMoment& moment) {
    return (moment.events & kEventFolded) != 0;
  });
  return found == run.moments.end() ? nullptr : &*found;
}

TEST(FoldEvent, EndsTheGripAndNamesItsReason) {
  const Overdone& run = overdone();

  const ExerciseMoment* moment = folded(run);

  ASSERT_NE(moment, nullptr);
  EXPECT_TRUE(moment->events & kEventReleased);
  EXPECT_FALSE(moment->events & kEventSlipped);
  EXPECT_EQ(moment->phase, ExercisePhase::kReleased);
  EXPECT_EQ(run.last.times.folded_us, moment->time_us);
  EXPECT_EQ(run.last.times.released_us, moment->time_us);
  EXPECT_EQ(run.last.times.slipped_us, -1);
}

TEST(FoldEvent, EndsTorqueAndForce) {
  const Overdone& run = overdone();
  const ExerciseMoment* moment = folded(run);
  ASSERT_NE(moment, nullptr);
  const auto at = static_cast<std::size_t>(moment->tick);

  const Sample& held = run.samples[at - 1];
  const Sample& released = run.samples[at];
  const Sample& later = run.samples[at + 100];

  EXPECT_EQ(held.phase, ExercisePhase::kTwisting);
  EXPECT_GT(norm(held.force_N), 0.05);
  EXPECT_GT(std::abs(held.response.torque_Nm), 1e-3);
  EXPECT_EQ(released.response.torque_Nm, 0.0);
  EXPECT_LT(norm(later.force_N), 0.2 * norm(held.force_N));
}

TEST(FoldEvent, IsFoundAgainInARerun) {
  const Overdone& run = overdone();
  const ExerciseMoment* moment = folded(run);
  ASSERT_NE(moment, nullptr);
  const RodSkin& skin = thinOrgan().rod->skin();
  TrialRerun rerun(thinOrgan(), run.trial.header, kServoRules);
  const auto bend = [&] { return skin.sharpestBend(skin.curveOf(rerun.organ().pose)); };

  const ReplayReport report = replayTrial(thinOrgan(), run.trial);
  for (std::int64_t tick = 0; tick + 1 < moment->tick; ++tick) {
    (void)rerun.next(run.samples[static_cast<std::size_t>(tick)]);
  }
  const ExercisePhase before = rerun.next(run.samples[static_cast<std::size_t>(moment->tick - 1)]).phase;
  const double bendBefore = bend();
  const ExercisePhase after = rerun.next(run.samples[static_cast<std::size_t>(moment->tick)]).phase;

  EXPECT_TRUE(report.identical()) << (report.first ? report.first->field : "");
  EXPECT_EQ(before, ExercisePhase::kTwisting);
  EXPECT_LE(bendBefore, kFoldingBend);
  EXPECT_EQ(after, ExercisePhase::kReleased);
  EXPECT_GT(bend(), kFoldingBend);
}

/// How a hand ends that turns the antrum of the shipped stomach about its own axis by 330 degrees, where the
/// held pylorus slips back by a whole turn.
struct Overturned {
  std::int64_t folded_tick = -1;
  double largest_rad = 0.0;  // while the jaw held
  Sample before, at, last;   // of the moment
};

Overturned overturned() {
  const Scene scene = testing::shippedScene("stomach", "partial");
  HandTask task = handTask(scene);
  task.targetAngle_rad = radians(330.0);
  ScriptedHand hand(
      {.seed = 5, .task = task, .profile = {.initialSkill = 1.0, .finalSkill = 1.0}, .duration_s = 6.0});
  SpscRing<ExerciseMoment> events(256);
  ServoLoop loop({.device = &hand, .scene = &scene, .events = &events}, {});
  Overturned run;
  for (int i = 0; i < 8500; ++i) {
    loop.tick(1000LL * i);
    for (ExerciseMoment moment; events.pop(moment);) {
      if ((moment.events & kEventFolded) != 0 && run.folded_tick < 0) {
        run.folded_tick = moment.tick;
        run.before = run.last;
        run.at = loop.lastSample();
      }
    }
    run.last = loop.lastSample();
    if (run.folded_tick < 0) {
      run.largest_rad = std::max(run.largest_rad, run.last.response.angle_rad);
    }
  }
  return run;
}

TEST(FoldEvent, EndsTheGripOfAnOrganThatSlipsBackByAWholeTurn) {
  const Overturned run = overturned();

  ASSERT_GE(run.folded_tick, 0);
  EXPECT_GT(run.largest_rad, radians(200.0));
  EXPECT_LT(run.largest_rad, radians(300.0));
  EXPECT_EQ(run.before.phase, ExercisePhase::kTwisting);
  EXPECT_GT(run.before.response.torque_Nm, 0.0);  // it still holds the turn that is counted
  EXPECT_EQ(run.at.phase, ExercisePhase::kReleased);
  EXPECT_LT(run.last.phase, ExercisePhase::kTwisting);  // the jaw may lie on what has turned back under it
  EXPECT_NEAR(run.last.response.angle_rad, 0.0, 0.02);
}

}  // namespace
}  // namespace torsio
