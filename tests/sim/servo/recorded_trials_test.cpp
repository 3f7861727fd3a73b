// SPDX-License-Identifier: GPL-3.0-or-later
// Trials that were recorded before jaw and shaft collided (rules 1, samples of format version 1), kept as
// they are in tests/data/trials: they must replay for ever.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial_file.h"
#include "sim/servo/replay_trial.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

/// The bar of those trials: its outline has the same bits on every machine.
const Scene& recordedScene() {
  static const Scene kScene = [] {
    testing::Outline2 circle;
    for (int i = 0; i < 72; ++i) {
      const SinCos at = portableSinCos(2.0 * kPi * i / 72.0);
      circle.push_back({kBarRadius_m * at.cos, kBarRadius_m * at.sin});
    }
    return barScene(testing::prism(circle, kBarLength_m, 40));
  }();
  return kScene;
}

Trial stored(const std::string& name) {
  return readTrialFile(std::filesystem::path(TORSIO_TEST_DATA) / "trials" / (name + ".trial"));
}

TEST(RecordedTrials, ReplayBitForBitByTheRulesOfTheirTime) {
  for (const char* name : {"rules-1-tangential", "rules-1-roll"}) {
    SCOPED_TRACE(name);
    const Trial trial = stored(name);

    const ReplayReport report = replayTrial(recordedScene(), trial);

    EXPECT_EQ(report.samples, 12'000);
    EXPECT_TRUE(report.identical()) << (report.first ? report.first->field : "");
    EXPECT_EQ(decodeChunk(trial.chunks.front()).front().rules, 1U);
  }
}

TEST(RecordedTrials, KeepTheirRulesWhenTheyAreWrittenAgain) {
  Trial trial = stored("rules-1-tangential");
  for (TrialChunk& chunk : trial.chunks) chunk = encodeChunk(chunk.index, decodeChunk(chunk));

  const std::vector<Sample> samples = decodeTrial(trial);

  EXPECT_EQ(samples, decodeTrial(stored("rules-1-tangential")));
  EXPECT_EQ(samples.back().rules, 1U);
}

TEST(RecordedTrials, OfANewerVersionAreRefusedInPlainWords) {
  Trial trial = stored("rules-1-tangential");
  std::vector<Sample> samples = decodeChunk(trial.chunks[3]);
  samples[10].rules = kServoRules + 1;
  trial.chunks[3] = encodeChunk(3, samples);
  trial.summary.contentHash = contentHash(trial);
  try {
    (void)replayTrial(recordedScene(), trial);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kVerifyFailed);
    EXPECT_NE(error.happened().find("rules"), std::string::npos);
  }
}

}  // namespace
}  // namespace torsio
