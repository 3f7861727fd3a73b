// SPDX-License-Identifier: GPL-3.0-or-later
// A whole untwisting through the servo loop: recorded, decoded, replayed.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/pose_track.h"
#include "sim/servo/replay_trial.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

constexpr std::int64_t kSecond = 1000;

struct Untwisting {
  Trial trial;
  std::vector<Sample> samples;
  std::uint32_t events = kEventNone;
  std::vector<ExerciseMoment> moments;  // each tick in which something happened
  HollowPose pose;
};

/// A skilled hand undoes the tube; a helper lets gas out and listens for blood.
Untwisting untwisting(const Scene& scene, const TrialId& trialId) {
  const std::uint64_t seed = detorsionSeed(trialId);
  ScriptedHandOptions options{
      .seed = 5, .task = detorseTask(scene, seed), .profile = {.initialSkill = 0.9, .finalSkill = 0.9}};
  options.duration_s = undone_s(*scene.hollow, ScriptedHand(options));
  ScriptedHand hand(options);
  Untwisting result;
  TrialHeader& header = result.trial.header;
  header.trialId = trialId;
  header.organHash = scene.organHash;
  header.parameterHash = scene.parameterHash;
  header.deviceLimits = deviceLimits(hand.capabilities());
  SpscRing<ServoCommand> commands(4);
  ServoLoop loop({.device = &hand, .scene = &scene, .commands = &commands}, servoOptions(header));
  const auto seconds = static_cast<std::int64_t>(options.duration_s);
  for (std::int64_t tick = 0; tick < seconds * kSecond; ++tick) {
    if (tick == 500) {
      (void)commands.push({ServoCommand::Kind::kVent, 1.0});
    }
    if (tick == 2000) {
      (void)commands.push({ServoCommand::Kind::kVent, 0.0});
    }
    if (tick == (seconds - 8) * kSecond) {
      (void)commands.push({ServoCommand::Kind::kCheckFlow, 3.0});
    }
    loop.tick(tick * 1000);
    result.events |= loop.lastEvents();
    result.samples.push_back(loop.lastSample());
    if (loop.lastEvents() != kEventNone) {
      result.moments.push_back({tick, tick * 1000, loop.lastEvents(), loop.lastSample().phase});
    }
  }
  result.pose = loop.organ().hollow;
  for (std::int64_t second = 0; second < seconds; ++second) {
    const auto first = static_cast<std::size_t>(second * kSecond);
    result.trial.chunks.push_back(encodeChunk(second, std::span(result.samples).subspan(first, kSecond)));
  }
  result.trial.summary = {seconds * kSecond, 0, 0, TrialOutcome::kCompleted, {}};
  result.trial.summary.contentHash = contentHash(result.trial);
  return result;
}

const Scene& tubeOfTrial() {
  static const Scene kScene = [] {
    Detorsion tube = twistedTube();
    tube.start.since_s = 3600.0;
    tube.limits.jawArea_m2 = 20e-6;
    return hollowScene(tube);
  }();
  return kScene;
}

const Untwisting& done() {
  static const Untwisting kDone = untwisting(tubeOfTrial(), "11111111-2222-3333-4444-555555555555");
  return kDone;
}

TEST(DetorsionTrial, IsUndoneByAScriptedHandInTheLeastNumberOfGrips) {
  const Sample& last = done().samples.back();
  const DetorsionLimits& limits = tubeOfTrial().hollow->detorsion().limits;
  int grips = 0;
  for (std::size_t i = 1; i < done().samples.size(); ++i) {
    grips += done().samples[i].phase == ExercisePhase::kTwisting &&
                     done().samples[i - 1].phase != ExercisePhase::kTwisting
                 ? 1
                 : 0;
  }

  EXPECT_EQ(grips, 2);  // 270 degrees, 155 a hand
  EXPECT_LE(std::abs(last.response.angle_rad), limits.residual_rad);
  EXPECT_GE(last.hollow.patency, limits.patency);
  EXPECT_GE(last.hollow.flow, limits.flow);
  EXPECT_TRUE(done().events & kEventClipped);
  EXPECT_TRUE(done().events & kEventUnclipped);
  EXPECT_TRUE(done().events & kEventChecked);
  EXPECT_FALSE(done().events & (kEventBruised | kEventTorn | kEventSlipped));
  EXPECT_EQ(last.phase, ExercisePhase::kTracking);
}

TEST(DetorsionTrial, StampsItsRulesAndHoldsNoNumberThatIsNotFinite) {
  for (const Sample& s : done().samples) {
    ASSERT_EQ(s.rules, kRulesOfDetorsionStandstill);
    ASSERT_TRUE(std::isfinite(s.hollow.pressure_Pa) && std::isfinite(s.hollow.patency) &&
                std::isfinite(s.hollow.flow) && std::isfinite(s.hollow.dose));
    ASSERT_TRUE(std::isfinite(s.response.torque_Nm) && isFinite(s.force_N));
  }
}

TEST(DetorsionTrial, IsKeptWithPressurePatencyFlowAndDose) {
  const std::vector<Sample> kept = decodeTrial(done().trial);

  ASSERT_EQ(kept.size(), done().samples.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const HollowReading& was = done().samples[i].hollow;
    ASSERT_NEAR(kept[i].hollow.pressure_Pa, was.pressure_Pa, 0.501 * kPressureStep_Pa);
    ASSERT_NEAR(kept[i].hollow.patency, was.patency, 0.501 * kShareStep);
    ASSERT_NEAR(kept[i].hollow.flow, was.flow, 0.501 * kShareStep);
    ASSERT_NEAR(kept[i].hollow.dose, was.dose, 0.501 * kDoseStep);
    ASSERT_EQ(kept[i].command, done().samples[i].command);
  }
  EXPECT_EQ(kept[500].command.kind, ServoCommand::Kind::kVent);
  EXPECT_LT(kept[3000].hollow.pressure_Pa, kept[0].hollow.pressure_Pa);
}

TEST(DetorsionTrial, ReplaysBitForBitWithAnOrganThatWasBuiltAnew) {
  Detorsion tube = *tubeOfTrial().pattern.detorsion;
  const Scene again = hollowScene(tube);

  const ReplayReport report = replayTrial(again, done().trial);

  EXPECT_TRUE(report.identical()) << (report.first ? report.first->field : "");
}

TEST(DetorsionTrial, StartsDifferentlyUnderAnotherTrialId) {
  Detorsion drawn = *tubeOfTrial().pattern.detorsion;
  drawn.start.least_rad = radians(200.0);
  const Scene scene = hollowScene(drawn);
  Trial trial = untwisting(scene, "a").trial;
  const bool own = replayTrial(scene, trial).identical();

  trial.header.trialId = "b";
  trial.summary.contentHash = contentHash(trial);

  EXPECT_TRUE(own);
  EXPECT_FALSE(replayTrial(scene, trial).identical());
}

TEST(DetorsionTrial, ReplaysFromItsSeedWithoutItsId) {
  TrialHeader blinded = done().trial.header;
  blinded.seed = detorsionSeed(blinded.trialId);
  blinded.trialId = "case A";

  const PoseTrack track(tubeOfTrial(), blinded, done().trial.chunks);

  const std::int64_t end_us = done().samples.back().device.time_us;
  EXPECT_EQ(track.hollowAt(end_us).check, done().pose.check);
  EXPECT_EQ(contentHash(done().trial), done().trial.summary.contentHash);
}

TEST(DetorsionTrial, SeesAChangedReadingInItsReplay) {
  Trial changed = done().trial;
  std::vector<Sample> samples = decodeChunk(changed.chunks[1]);
  samples[10].hollow.flow += 1e-3;
  changed.chunks[1] = encodeChunk(1, samples);
  changed.summary.contentHash = contentHash(changed);

  const ReplayReport report = replayTrial(tubeOfTrial(), changed);

  EXPECT_EQ(report.differentSamples, 1);
  ASSERT_TRUE(report.first);
  EXPECT_EQ(report.first->field, "flow");
}

TEST(DetorsionTrial, HoldsTheStateOfTheOrganForViews) {
  const PoseTrack track(tubeOfTrial(), done().trial.header, done().trial.chunks);
  const HollowPose end = track.hollowAt(done().samples.back().device.time_us);

  EXPECT_EQ(track.hollowAt(0).start_rad, radians(270.0));
  EXPECT_EQ(end.check, done().pose.check);
  EXPECT_EQ(end.check.done, FlowCheck::kDoppler);
  EXPECT_EQ(end.clipped, done().pose.clipped);
  EXPECT_TRUE(end.present);
}

TEST(DetorsionTrial, IgnoresInvalidCommands) {
  ScriptedHand hand({.task = handTask(tubeOfTrial()), .profile = {}, .duration_s = 5.0});
  SpscRing<ServoCommand> commands(8);
  ServoLoop loop({.device = &hand, .scene = &tubeOfTrial(), .commands = &commands}, {});
  for (const double value : {0.0, 4.0, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
    (void)commands.push({ServoCommand::Kind::kCheckFlow, value});
  }

  for (std::int64_t tick = 0; tick < 6; ++tick) {
    loop.tick(tick * 1000);
    EXPECT_EQ(loop.lastSample().command.kind, ServoCommand::Kind::kNone);
  }

  EXPECT_EQ(loop.organ().hollow.check.running, FlowCheck::kNone);
}

TEST(DetorsionTrial, RerunFindsTheSameMoments) {
  const std::vector<Sample> kept = decodeTrial(done().trial);

  const auto all = rerunMoments(tubeOfTrial(), done().trial.header, kept, ~0U);
  const auto clips = rerunMoments(tubeOfTrial(), done().trial.header, kept, kEventClipped);

  EXPECT_EQ(all, done().moments);
  ASSERT_FALSE(clips.empty());
  EXPECT_LT(clips.size(), all.size());
  for (const ExerciseMoment& moment : clips) {
    EXPECT_EQ(moment.events, static_cast<std::uint32_t>(kEventClipped));
  }
  EXPECT_TRUE(rerunMoments(tubeOfTrial(), done().trial.header, {}, ~0U).empty());
}

}  // namespace
}  // namespace torsio
