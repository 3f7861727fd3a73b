// SPDX-License-Identifier: GPL-3.0-or-later
// The stomach in the jaw: an organ that is a rod, tick by tick.
// A thin organ of a user's, turned on until its tissue would have to fold: the jaw lets go and says why.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
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
#include "sim/servo/pose_track.h"
#include "sim/servo/replay_trial.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/recorded_trial.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

std::shared_ptr<const Scene> stomach(const std::string& pattern) {
  return std::make_shared<const Scene>(testing::shippedScene("stomach", pattern));
}

/// A hand that grips where the scripted one does and then turns about the task's axis at will.
class TurningHand {
 public:
  explicit TurningHand(std::shared_ptr<const Scene> scene)
      : scene_(std::move(scene)), task_(handTask(*scene_)), exercise_({}, *scene_) {
    const Vec3 way = task_.graspPoint_m - task_.axisCentre_m;
    const Vec3 outwards = normalized(way - dot(way, task_.axisDirection) * task_.axisDirection);
    open_.pose.position_m = task_.graspPoint_m + 0.001 * outwards;
    const Vec3 side = cross(task_.axisDirection, outwards);
    open_.pose.orientation = orientationOf(side, task_.axisDirection, outwards);
    (void)exercise_.step(open_);
    ToolState closed = open_;
    closed.grip = 1.0;
    (void)exercise_.step(closed);
    last_ = exercise_.step(closed);
  }

  /// Turns on to `angle_rad` within `ticks` ticks.
  const ExerciseStep& turnTo(double angle_rad, int ticks) {
    const double from_rad = angle_rad_;
    for (int k = 1; k <= ticks; ++k) {
      angle_rad_ = from_rad + (angle_rad - from_rad) * k / ticks;
      step(tool(angle_rad_));
    }
    return last_;
  }

  [[nodiscard]] ToolState tool(double angle_rad) const {
    ToolState turned = open_;
    turned.grip = 1.0;
    turned.pose.position_m = task_.axisCentre_m + rotateAbout(open_.pose.position_m - task_.axisCentre_m,
                                                              task_.axisDirection, angle_rad);
    turned.pose.orientation = axisAngle(task_.axisDirection, angle_rad) * open_.pose.orientation;
    return turned;
  }

  const ExerciseStep& step(const ToolState& tool) {
    last_ = exercise_.step(tool);
    events_ |= last_.events;
    return last_;
  }

  [[nodiscard]] const ExerciseStep& last() const { return last_; }
  [[nodiscard]] std::uint32_t events() const { return events_; }
  [[nodiscard]] const Exercise& exercise() const { return exercise_; }
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const ToolState& open() const { return open_; }

 private:
  /// The rotation whose columns are three perpendicular unit vectors.
  static Quat orientationOf(const Vec3& x, const Vec3& y, const Vec3& z) {
    const double w2 = 1.0 + x.x + y.y + z.z;
    if (w2 > 1e-3) {
      const double w = 0.5 * std::sqrt(w2);
      return normalized(Quat{w, (y.z - z.y) / (4 * w), (z.x - x.z) / (4 * w), (x.y - y.x) / (4 * w)});
    }
    return axisAngle({0, 0, 1}, kPi) * orientationOf({-x.x, -x.y, x.z}, {-y.x, -y.y, y.z}, {-z.x, -z.y, z.z});
  }

  std::shared_ptr<const Scene> scene_;
  HandTask task_;
  Exercise exercise_;
  ToolState open_;
  ExerciseStep last_;
  std::uint32_t events_ = kEventNone;
  double angle_rad_ = 0.0;
};

TEST(RodExercise, AnswersAHeldTurnAsThePoseAtRestDoes) {
  TurningHand hand(stomach("organo-axial"));
  const TaskPoint byTheBook = atAngle(hand.scene().rod->path(), radians(-90.0));

  hand.turnTo(byTheBook.hand_rad, 1500);
  const ExerciseStep& held = hand.turnTo(byTheBook.hand_rad, 1000);

  // The jaw holds the skin, the pose at rest was computed with a hand at the section's centre.
  EXPECT_EQ(held.phase, ExercisePhase::kTwisting);
  EXPECT_NEAR(degrees(held.response.angle_rad), -90.0, 3.0);
  EXPECT_NEAR(held.response.torque_Nm, byTheBook.torque_Nm, 0.3 * std::abs(byTheBook.torque_Nm));
  EXPECT_LT(norm(held.response.force_N), 2.0);
}

TEST(RodExercise, TheForceOnTheTipIsTheChangeOfTheStoredEnergy) {
  TurningHand hand(stomach("partial"));
  hand.turnTo(radians(40.0), 800);
  hand.turnTo(radians(40.0), 1500);
  const double less_Nm = hand.last().response.torque_Nm;
  hand.turnTo(radians(42.0), 400);
  hand.turnTo(radians(42.0), 1500);
  const double more_Nm = hand.last().response.torque_Nm;
  const Vec3 tip_m = hand.tool(radians(42.0)).pose.position_m;

  // Turning on costs more; the force on the tip is the torque over its arm, against the turn.
  EXPECT_GT(more_Nm, less_Nm);
  const RodOrgan& organ = *hand.scene().rod;
  const AxisFrame axis =
      organ.grip(organ.rod().rest(), hand.last().response.graspArc_m, hand.open().pose).axis;
  const Vec3 way = tip_m - axis.centre_m;
  const double arm_m = norm(way - dot(way, axis.tangent) * axis.tangent);
  ASSERT_GT(arm_m * arm_m, organ.turnStiffness_Nm_per_rad() / kStiffnessCap_N_per_m);
  EXPECT_NEAR(norm(hand.last().response.force_N) * arm_m, more_Nm, 0.02 * more_Nm);
}

TEST(RodExercise, AReleasedOrganComesBackToItsRest) {
  TurningHand hand(stomach("organo-axial"));
  hand.turnTo(radians(-120.0), 1500);
  ToolState away = hand.open();
  away.pose.position_m += Vec3{0.0, -0.2, 0.0};

  int ticks = 0;
  for (; ticks < 10'000 && hand.exercise().phase() != ExercisePhase::kTracking; ++ticks) {
    hand.step(away);
  }

  EXPECT_TRUE(hand.events() & kEventReleased);
  EXPECT_TRUE(hand.events() & kEventReturned);
  EXPECT_TRUE(hand.exercise().organ().atRest())
      << degrees(hand.exercise().organ().twist.graspAngle_rad) << " degrees, "
      << hand.scene().rod->farthestFromRest_m(hand.exercise().organ().pose) << " m after " << ticks;
  EXPECT_LT(ticks, 3000);
  EXPECT_EQ(norm(hand.last().response.force_N), 0.0);
}

TEST(RodExercise, LetsGoBeforeTheTissueFolds) {
  TurningHand hand(stomach("partial"));

  for (int k = 0; k < 8 && hand.exercise().phase() == ExercisePhase::kTwisting; ++k) {
    hand.turnTo(radians(90.0 * (k + 1)), 1000);
  }

  EXPECT_TRUE(hand.events() & kEventReleased);
  EXPECT_TRUE(hand.events() & (kEventFolded | kEventSlipped));
}

TEST(RodExercise, IgnoresAPoseThatIsNotFinite) {
  TurningHand hand(stomach("organo-axial"));
  hand.turnTo(radians(-30.0), 500);
  const RodPose before = hand.exercise().organ().pose;
  ToolState lost = hand.tool(radians(-30.0));
  lost.pose.position_m.x = std::numeric_limits<double>::quiet_NaN();

  hand.step(lost);

  EXPECT_EQ(hand.exercise().organ().pose, before);
  EXPECT_TRUE(std::isfinite(hand.last().response.angle_rad));
  EXPECT_TRUE(std::isfinite(hand.last().response.torque_Nm));
}

TEST(RodExercise, LetsGoWhenTheDeviceIsLost) {
  TurningHand hand(stomach("organo-axial"));
  hand.turnTo(radians(-60.0), 1000);
  const double held_Nm = hand.last().response.torque_Nm;
  const RodPose before = hand.exercise().organ().pose;
  ToolState lost = hand.tool(radians(-60.0));
  lost.status = kDeviceLost;

  hand.step(lost);

  EXPECT_GT(std::abs(held_Nm), 1e-3);
  EXPECT_EQ(hand.last().phase, ExercisePhase::kReleased);
  EXPECT_EQ(hand.last().response.torque_Nm, 0.0);
  EXPECT_TRUE(hand.events() & kEventReleased);
  EXPECT_EQ(hand.exercise().organ().pose, before);  // it swings back from there
}

TEST(RodExercise, GripsTheTwistedOrganWhereItLies) {
  TurningHand hand(stomach("organo-axial"));
  hand.turnTo(radians(-60.0), 1000);
  const OrganState& organ = hand.exercise().organ();
  const Vec3 rest_m = hand.scene().mesh.vertices_m[1000];
  const Vec3 now_m = hand.scene().toDeformed_m(rest_m, organ);
  ASSERT_GT(norm(now_m - rest_m), 0.002);
  ToolState tool = hand.open();
  tool.pose.position_m = now_m;

  const auto held = tissueInMouth(toolShape(tool, hand.scene().instrument), tool, hand.scene(), organ);

  ASSERT_TRUE(held);
  EXPECT_LT(norm(held->position_m - rest_m), 0.008);
}

TEST(RodExercise, ATrialReplaysBitForBitAndItsShapesAreFoundAgain) {
  const std::shared_ptr<const Scene> scene = stomach("organo-axial");
  ScriptedHandOptions options{.seed = 3,
                              .task = handTask(*scene),
                              .profile = {.initialSkill = 0.6, .finalSkill = 0.6},
                              .duration_s = 9.0};
  ScriptedHand hand(options);
  ServoLoop loop({.device = &hand, .scene = scene.get()}, {});
  std::vector<RodPose> shapes;
  const Trial trial =
      recordedTrial(loop, headerOf(*scene, hand), 9, [&] { shapes.push_back(loop.organ().pose); });
  const std::shared_ptr<const Scene> again = stomach("organo-axial");

  const ReplayReport report = replayTrial(*again, trial);
  const PoseTrack track(*again, trial.header, trial.chunks);

  EXPECT_TRUE(report.identical());
  double farthest_m = 0.0;
  int moved = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const RodPose shown = track.at(1000LL * static_cast<std::int64_t>(i));
    ASSERT_EQ(shown.count, shapes[i].count) << i;
    moved += shown.count > 0 ? 1 : 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(shown.count); ++n) {
      farthest_m = std::max(farthest_m, norm(shown.nodes[n].position_m - shapes[i].nodes[n].position_m));
    }
  }
  EXPECT_GT(moved, 1000);
  EXPECT_LT(farthest_m, 0.008);  // a tick of the return, when all is let go
}

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
    const TrialHeader header = headerOf(scene, hand);
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
