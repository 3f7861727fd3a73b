// SPDX-License-Identifier: GPL-3.0-or-later
// An exercise with the pointer: run, recorded, stored as a file, replayed. The servo is stepped by hand.

#include "sim/record/trial.h"

#include <cmath>
#include <memory>

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/gui/simulator/posed_states.h"
#include "app/gui/simulator/replay_bar.h"
#include "app/gui/simulator/trial_recording.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/recording/trial_playback.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/record/sample_codec.h"
#include "sim/servo/replay_trial.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio::gui {

namespace {

constexpr double kGraspHeight_m = 0.8 * kBarLength_m;
constexpr double kTwist_rad = 0.7;
// The pointer device follows with two filters of 15 ms: after 300 ms, less than 1e-6 of the distance is left.
constexpr double kSettled_rad = 1e-4;

class PointerRun : public ::testing::Test {
 protected:
  std::shared_ptr<const Scene> scene_ = std::make_shared<const Scene>(barScene());
  Pose start_{.position_m = {0.0, -kBarRadius_m - 0.010, kGraspHeight_m}, .orientation = {}};
  PointerInput input_;
  PointerDevice* pointer_ = nullptr;  // of the latest run

  /// Starts a run with the pointer; `kept` null: not recorded.
  std::unique_ptr<RecordedRun> newRun(const std::shared_ptr<TrialSink>& kept = nullptr) {
    auto pointer = std::make_unique<PointerDevice>(start_);
    pointer_ = pointer.get();
    return std::make_unique<RecordedRun>(scene_, std::move(pointer),
                                         RecordingSpec{.trialId = "one", .targetAngle_rad = 1.0}, kept);
  }

  /// Reaches, grips, and turns about the bar's axis (camera upright in front: its y is the bar's axis).
  void twist(RecordedRun& live) {
    input_.present = true;
    input_.view = Quat{0.70710678118654752, 0.70710678118654752, 0.0, 0.0};
    input_.onPlane_m = {0.0, -kBarRadius_m - 0.002, kGraspHeight_m};
    pointer_->publish(input_);
    live.step(300);
    input_.grip = 1.0;
    pointer_->publish(input_);
    live.step(300);
    input_.yaw_rad = kTwist_rad;
    pointer_->publish(input_);
    live.step(300);
  }
};

TEST_F(PointerRun, AMouseReachesGripsAndTwistsTheBarByTurning) {
  const std::unique_ptr<RecordedRun> live = newRun();

  twist(*live);

  const LiveState state = live->latest();
  EXPECT_EQ(state.phase, ExercisePhase::kTwisting);
  EXPECT_NEAR(state.response.angle_rad, kTwist_rad, kSettled_rad);
  EXPECT_GT(state.response.torque_Nm, 0.0);
  EXPECT_EQ(state.targetAngle_rad, 1.0);
}

TEST_F(PointerRun, OpeningTheJawLetsTheTissueReturn) {
  const std::unique_ptr<RecordedRun> live = newRun();
  twist(*live);

  input_.grip = 0.0;
  pointer_->publish(input_);
  live->step(2000);

  EXPECT_EQ(live->latest().response.angle_rad, 0.0);
  EXPECT_NE(live->latest().phase, ExercisePhase::kTwisting);
}

TEST_F(PointerRun, ACommandReachesTheServo) {
  const std::unique_ptr<RecordedRun> live = newRun();
  twist(*live);

  ASSERT_TRUE(live->command({.kind = ServoCommand::Kind::kReleaseTissue}));
  live->step();

  EXPECT_EQ(live->latest().phase, ExercisePhase::kReleased);
}

TEST_F(PointerRun, IsRecordedFromTheFirstTickAndReplaysBitForBit) {
  auto kept = std::make_shared<MemoryTrialSink>();
  {
    const std::unique_ptr<RecordedRun> live = newRun(kept);
    twist(*live);
    const RecordingResult result = live->finish(TrialOutcome::kCompleted);
    EXPECT_EQ(result.summary.samples, 900);
    EXPECT_EQ(result.summary.refusedSamples, 0);
  }

  const Trial& trial = kept->trial();
  EXPECT_EQ(trial.header.deviceModel, "Mouse and keyboard");
  EXPECT_EQ(trial.header.drive, TwistDrive::kRoll);
  EXPECT_EQ(trial.summary.outcome, TrialOutcome::kCompleted);
  EXPECT_TRUE(replayTrial(*scene_, trial).identical());
}

/// The bar's trial, as if read from a database.
class RecordedTwist : public PointerRun {
 protected:
  Trial trial_;

  void SetUp() override {
    auto kept = std::make_shared<MemoryTrialSink>();
    const std::unique_ptr<RecordedRun> live = newRun(kept);
    twist(*live);
    ASSERT_TRUE(live->command({.kind = ServoCommand::Kind::kSetTarget, .value = 0.5}));
    live->step(100);
    static_cast<void>(live->finish(TrialOutcome::kCompleted));
    trial_ = kept->trial();
  }
};

TEST_F(RecordedTwist, PlaybackShowsWhatWasRecordedAtAnyTime) {
  TrialPlayback playback(trial_);
  const std::vector<Sample> samples = decodeTrial(trial_);

  EXPECT_EQ(playback.duration_us(), 999'000);
  for (const std::int64_t tick : {0, 450, 899, 999}) {
    playback.seek_us(tick * 1000);
    const LiveState state = playback.state();
    EXPECT_EQ(state.tick, tick);
    EXPECT_EQ(state.response, samples[static_cast<std::size_t>(tick)].response);
    EXPECT_EQ(state.phase, samples[static_cast<std::size_t>(tick)].phase);
  }
}

TEST_F(RecordedTwist, PlaybackShowsTheTargetInForce) {
  TrialPlayback playback(trial_);

  playback.seek_us(100'000);
  EXPECT_EQ(playback.state().targetAngle_rad, 1.0);
  playback.seek_us(950'000);
  EXPECT_EQ(playback.state().targetAngle_rad, 0.5);
}

TEST_F(RecordedTwist, PlaybackMovesAtItsSpeedAndStopsAtTheEnd) {
  TrialPlayback playback(trial_);

  playback.advance(0.1);
  EXPECT_EQ(playback.position_us(), 0);  // not playing yet
  playback.setPlaying(true);
  playback.setSpeed(2.0);
  playback.advance(0.1);
  EXPECT_EQ(playback.position_us(), 200'000);
  playback.advance(10.0);
  EXPECT_EQ(playback.position_us(), playback.duration_us());
  EXPECT_FALSE(playback.playing());
  playback.setPlaying(true);
  EXPECT_EQ(playback.position_us(), 0);  // restarts at the end
}

TEST_F(RecordedTwist, AnEmptyTrialIsRefused) {
  EXPECT_THROW(TrialPlayback(Trial{}), Error);
}

TEST_F(RecordedTwist, TrialFilesAreListedNewestFirstAndReadBack) {
  const QTemporaryDir folder;
  const TrialRecording files = trialFiles((folder.path() + QStringLiteral("/trials")).toStdString());
  EXPECT_TRUE(files.list().empty());

  for (const std::int64_t started_us : {1'000'000, 3'000'000, 2'000'000}) {
    TrialHeader header = trial_.header;
    header.startedUtc_us = started_us;
    header.trialId = "at-" + std::to_string(started_us);
    const std::unique_ptr<TrialSink> sink = files.open({.trialId = header.trialId});
    sink->begin(header);
    for (const TrialChunk& chunk : trial_.chunks) {
      sink->append(chunk);
    }
    sink->finish(trial_.summary);
  }

  const std::vector<RecordedTrial> listed = files.list();
  ASSERT_EQ(listed.size(), 3U);
  EXPECT_EQ(listed[0].id, "at-3000000");
  EXPECT_EQ(listed[2].id, "at-1000000");
  EXPECT_NEAR(listed[0].duration_s, 1.0, 1e-9);
  EXPECT_EQ(files.load("at-2000000").chunks.size(), trial_.chunks.size());
  EXPECT_THROW(static_cast<void>(files.load("never")), Error);
}

TEST(ScriptedTwist, HoldsTheTargetOnAManualClock) {
  const Scene bar = barScene();

  const LiveState state = scriptedTwist(bar, 0.9);

  EXPECT_EQ(state.phase, ExercisePhase::kTwisting);
  EXPECT_NEAR(state.response.angle_rad, 0.9, 0.02);  // a practised hand still trembles
  EXPECT_GT(state.response.torque_Nm, 0.0);
}

TEST(ScriptedTwist, ATargetOfZeroLeavesTheOrganAtRest) {
  const Scene bar = barScene();

  EXPECT_NEAR(scriptedTwist(bar, 0.0).response.angle_rad, 0.0, 0.02);
}

std::vector<double> roundedDegrees(const std::vector<double>& angles_rad) {
  std::vector<double> rounded;
  for (const double angle_rad : angles_rad) {
    rounded.push_back(std::round(degrees(angle_rad) * 1e6) / 1e6);
  }
  return rounded;
}

TEST(FilmStrip, StepsByThirtyDegreesAndEndsAtTheLastAngle) {
  EXPECT_EQ(roundedDegrees(stripAngles_rad(radians(90.0))), (std::vector<double>{0, 30, 60, 90}));
  EXPECT_EQ(roundedDegrees(stripAngles_rad(radians(-70.0))), (std::vector<double>{0, -30, -60, -70}));
  EXPECT_EQ(stripAngles_rad(0.0).size(), 1U);
}

TEST(FilmStrip, CaptionsHaveNoNeedlessDigits) {
  EXPECT_EQ(angleCaption(-0.0), QStringLiteral("0\u00b0"));
  EXPECT_EQ(angleCaption(radians(60.0)), QStringLiteral("60\u00b0"));
  EXPECT_EQ(angleCaption(radians(22.5)), QStringLiteral("22.5\u00b0"));
}

TEST(FilmStrip, FindsWhenARecordingFirstReachesEachAngle) {
  // Up to 60 degrees within 2 s, then 3 s back to 0: 30 degrees are passed twice.
  Trial trial;
  trial.header.trialId = "strip";
  std::vector<Sample> samples;
  for (std::int64_t tick = 0; tick < 5000; ++tick) {
    Sample sample;
    sample.tick = tick;
    sample.device.time_us = 1000 * tick;
    sample.response.angle_rad = kRadiansPerDegree * (tick <= 2000 ? 0.03 * static_cast<double>(tick)
                                                                  : 0.02 * static_cast<double>(5000 - tick));
    samples.push_back(sample);
  }
  for (std::int64_t index = 0; index * kSamplesPerChunk < 5000; ++index) {
    const auto from = samples.begin() + index * kSamplesPerChunk;
    const std::vector<Sample> second(from, from + kSamplesPerChunk);
    trial.chunks.push_back(encodeChunk(index, second));
  }
  trial.summary.samples = 5000;

  const std::vector<StripMoment> moments = stripMoments(TrialPlayback(trial));

  ASSERT_EQ(moments.size(), 3U);
  EXPECT_EQ(moments[0].position_us, 0);
  EXPECT_NEAR(static_cast<double>(moments[1].position_us), 1e6, 2000.0);  // a tick either way
  EXPECT_NEAR(static_cast<double>(moments[2].position_us), 2e6, 2000.0);
}

TEST(FilmStrip, PutsFourInARowAndLeavesTheRestOfTheLastRowWhite) {
  QImage red(100, 50, QImage::Format_RGB32);
  red.fill(Qt::red);
  const std::vector<StripFrame> frames(5, StripFrame{QString(), red});

  const QImage strip = filmStrip(stripRows(frames));

  ASSERT_FALSE(strip.isNull());
  const int cell = strip.width() / 4;
  const int row = strip.height() / 2;
  for (int column = 0; column < 4; ++column) {
    EXPECT_EQ(strip.pixelColor(column * cell + cell / 2, row / 3), QColor(Qt::red));
  }
  EXPECT_EQ(strip.pixelColor(cell / 2, row + row / 3), QColor(Qt::red));
  EXPECT_EQ(strip.pixelColor(cell + cell / 2, row + row / 3), QColor(Qt::white));
}

TEST(FilmStrip, MakesNoPictureWithoutFrames) {
  EXPECT_TRUE(filmStrip(stripRows({})).isNull());
  EXPECT_TRUE(filmStrip(stripRows({StripFrame{}})).isNull());
}

}  // namespace

}  // namespace torsio::gui
