// SPDX-License-Identifier: GPL-3.0-or-later
// Trials that were recorded by the first released version, kept as they are in tests/data/trials: they must
// replay for ever. They were made once, by `write_first_release` (tests/db), and are never made again.
// A replay on several threads says what a replay on one thread says, whatever the record claims.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/random.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial_file.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/recorded_trial.h"
#include "tests/support/refusal.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

Trial stored(const std::string& name) {
  return readTrialFile(std::filesystem::path(TORSIO_TEST_DATA) / "trials" / (name + ".trial"));
}

TEST(RecordedTrials, ReplayBitForBitByTheRulesOfTheirTime) {
  for (const char* name : {"first-release-tangential", "first-release-roll"}) {
    SCOPED_TRACE(name);
    const Trial trial = stored(name);

    const ReplayReport report = replayTrial(recordedBar(), trial);

    EXPECT_EQ(report.samples, 8'000);
    EXPECT_TRUE(report.identical()) << (report.first ? report.first->field : "");
    EXPECT_EQ(decodeChunk(trial.chunks.front()).front().rules, 1U);
  }
}

TEST(RecordedTrials, ContainATwist) {
  for (const char* name : {"first-release-tangential", "first-release-roll"}) {
    SCOPED_TRACE(name);

    const std::vector<Sample> samples = decodeTrial(stored(name));

    for (const ExercisePhase phase : {ExercisePhase::kTracking, ExercisePhase::kContact,
                                      ExercisePhase::kTwisting, ExercisePhase::kReleased}) {
      EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [&](const Sample& sample) {
        return sample.phase == phase;
      })) << static_cast<int>(phase);
    }
  }
}

TEST(RecordedTrials, KeepTheirRulesWhenTheyAreWrittenAgain) {
  Trial trial = stored("first-release-tangential");
  for (TrialChunk& chunk : trial.chunks) {
    chunk = encodeChunk(chunk.index, decodeChunk(chunk));
  }

  const std::vector<Sample> samples = decodeTrial(trial);

  EXPECT_EQ(samples, decodeTrial(stored("first-release-tangential")));
  EXPECT_EQ(samples.back().rules, 1U);
}

TEST(RecordedTrials, FromANewerVersionAreRefusedInPlainWords) {
  Trial trial = stored("first-release-tangential");
  std::vector<Sample> samples = decodeChunk(trial.chunks[3]);
  samples[10].rules = kServoRules + 1;
  trial.chunks[3] = encodeChunk(3, samples);
  trial.summary.contentHash = contentHash(trial);
  const Error error = testing::refusal([&] { return replayTrial(recordedBar(), trial); });
  EXPECT_EQ(error.code(), ErrorCode::kVerifyFailed);
  EXPECT_NE(error.happened().find("rules"), std::string::npos);
}

constexpr std::int64_t kChunk = 1000;

/// What a scripted hand does for so many seconds, with several grips.
Trial recordedIn(const Scene& scene, std::uint64_t seed, std::int64_t seconds) {
  ScriptedHand hand({.seed = seed,
                     .task = handTask(scene),
                     .profile = {.initialSkill = 0.6, .finalSkill = 0.6},
                     .duration_s = static_cast<double>(seconds)});
  TrialHeader header = headerOf(scene, hand);
  header.trialId = "00000000-0000-4000-8000-000000000009";
  header.targetAngle_rad = scene.pattern.targetAngle_rad;
  ServoLoop loop({.device = &hand, .scene = &scene}, servoOptions(header));
  return recordedTrial(loop, header, seconds);
}

const Trial& barTrial() {
  static const Trial kTrial = recordedIn(recordedBar(), 4, 16);
  return kTrial;
}

void expectSame(const ReplayReport& a, const ReplayReport& b) {
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.differentSamples, b.differentSamples);
  EXPECT_EQ(a.chunks, b.chunks);
  EXPECT_EQ(a.differentChunks, b.differentChunks);
  EXPECT_EQ(a.contentIntact, b.contentIntact);
  EXPECT_EQ(a.gapAfterTick, b.gapAfterTick);
  ASSERT_EQ(a.first.has_value(), b.first.has_value());
  if (a.first) {
    EXPECT_EQ(a.first->tick, b.first->tick);
    EXPECT_EQ(a.first->field, b.first->field);
    EXPECT_EQ(a.first->recorded, b.first->recorded);
    EXPECT_EQ(a.first->replayed, b.first->replayed);
  }
}

/// Changes something in one sample as a forger would: the chunk is packed anew, its digest of answers stays.
void forge(Trial& trial, Random& random) {
  TrialChunk& chunk = trial.chunks[random.bounded(trial.chunks.size())];
  std::vector<Sample> samples = decodeChunk(chunk);
  Sample& sample = samples[random.bounded(samples.size())];
  switch (random.bounded(8)) {
    case 0:
      sample.device.position[random.bounded(3)] += 1 + static_cast<std::int32_t>(random.bounded(100'000));
      break;
    case 1:
      sample.device.grip = sample.device.grip > 0 ? 0 : 10'000'000;
      break;
    case 2:
      sample.phase =
          static_cast<ExercisePhase>((static_cast<unsigned>(sample.phase) + 1 + random.bounded(3)) % 4);
      break;
    case 3:
      sample.contact ^= 1U << random.bounded(3);
      break;
    case 4:
      sample.response.torque_Nm += 1e-6;
      break;
    case 5:
      sample.response.depth_m += 1e-7;
      break;
    case 6:
      sample.force_N.y -= 1e-5;
      break;
    default:
      sample.command = {ServoCommand::Kind::kReleaseTissue, 0.0};
      break;
  }
  const std::string answers = chunk.outputDigest;
  chunk = encodeChunk(chunk.index, samples);
  chunk.outputDigest = answers;
}

TEST(ExerciseAhead, ReplaysBitForBitOnAnyNumberOfThreads) {
  for (const unsigned threads : {0U, 1U, 2U, 3U, 7U}) {
    SCOPED_TRACE(threads);

    const ReplayReport report = replayTrial(recordedBar(), barTrial(), threads);

    EXPECT_TRUE(report.identical()) << (report.first ? report.first->field : "");
    EXPECT_EQ(report.samples, 16'000);
  }
}

TEST(ExerciseAhead, ReplaysAnOrganThatIsARod) {
  const Scene stomach = testing::shippedScene("stomach");
  const Trial trial = recordedIn(stomach, 5, 12);

  const ReplayReport report = replayTrial(stomach, trial, 3);

  EXPECT_TRUE(report.identical()) << (report.first ? report.first->field : "");
  EXPECT_EQ(report.samples, 12'000);
}

TEST(ExerciseAhead, FindsAChangedSampleWhereAReplayOnOneThreadFindsIt) {
  Random random(17);
  int found = 0;
  for (int i = 0; i < 24; ++i) {
    SCOPED_TRACE(i);
    Trial trial = barTrial();
    forge(trial, random);

    const ReplayReport parallel = replayTrial(recordedBar(), trial, 3);

    const ReplayReport plain = replayTrial(recordedBar(), trial, 1);
    expectSame(parallel, plain);
    EXPECT_FALSE(parallel.identical());
    found += parallel.first ? 1 : 0;
  }
  EXPECT_GT(found, 12);
}

TEST(ExerciseAhead, StopsAtAGapAsAReplayOnOneThread) {
  Trial trial = barTrial();
  std::vector<Sample> samples = decodeChunk(trial.chunks[11]);
  samples.erase(samples.begin() + 400);
  trial.chunks[11] = encodeChunk(11, samples);

  const ReplayReport parallel = replayTrial(recordedBar(), trial, 3);

  EXPECT_EQ(parallel.gapAfterTick, 11'399);
  expectSame(parallel, replayTrial(recordedBar(), trial, 1));
}

TEST(ExerciseAhead, IsNotMisledByARecordThatClaimsNothingIsTouched) {
  std::vector<Sample> samples = decodeTrial(barTrial());
  for (Sample& sample : samples) {
    sample.phase = ExercisePhase::kTracking;
    sample.contact = kContactNone;
  }
  const ExerciseOptions options = TrialRerun::exerciseOptions(barTrial().header, samples.front().rules);
  Exercise exercise(options, recordedBar());
  ExerciseAhead ahead(recordedBar(), options, samples, 3);
  std::uint32_t seen = kEventNone;
  for (const Sample& sample : samples) {
    const ExerciseStep expected = exercise.step(toolState(sample.device));

    const ExerciseStep& answer = ahead.next();

    ASSERT_EQ(answer.response, expected.response);
    ASSERT_EQ(answer.phase, expected.phase);
    ASSERT_EQ(answer.events, expected.events);
    ASSERT_EQ(answer.contact, expected.contact);
    ASSERT_EQ(answer.patches, expected.patches);
    seen |= answer.events;
  }
  EXPECT_NE(seen & kEventGripped, 0U);
  EXPECT_NE(seen & kEventReturned, 0U);
  EXPECT_GT(ahead.piecesAgain(), 0U);
}

}  // namespace
}  // namespace torsio
