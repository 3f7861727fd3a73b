// SPDX-License-Identifier: GPL-3.0-or-later
// Trials that were recorded by the first released version, kept as they are in tests/data/trials: they must
// replay for ever. They were made once, by `write_first_release` (tests/db), and are never made again.
#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial_file.h"
#include "sim/servo/replay_trial.h"
#include "tests/sim/servo/recorded_bar.h"

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
  try {
    (void)replayTrial(recordedBar(), trial);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kVerifyFailed);
    EXPECT_NE(error.happened().find("rules"), std::string::npos);
  }
}

}  // namespace
}  // namespace torsio
