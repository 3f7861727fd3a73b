// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/demonstration_marks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace torsio {
namespace {

std::vector<std::string> codes(char letter, std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < count; ++i) {
    std::string code(1, letter);
    code += std::to_string(100 + i);
    out.push_back(code);
  }
  return out;
}

DemonstrationPeople people() {
  return {{codes('x', 10), codes('y', 10), codes('z', 10)},
          codes('R', 10),
          {codes('A', 20), codes('B', 10), codes('C', 10)}};
}

const ScoreScale kOneToTen{10, 100, 10};

TEST(DemonstrationTrainingMarks, FollowThePatternOfThePaperForManySeeds) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::vector<TrainingMark> marks = demonstrationTrainingMarks(kOneToTen, people(), seed);
    ASSERT_EQ(marks.size(), 900U);
    const std::vector<GroupSummary> s = groupSummaries(kOneToTen, marks);
    // s[3 t + g]. Platform notes, row T10: equal before; 1 and 2 slightly above 3; then 2 clearly best, 1
    // above 3.
    EXPECT_NEAR(s[0].mean, s[1].mean, 0.35) << seed;
    EXPECT_NEAR(s[0].mean, s[2].mean, 0.35) << seed;
    EXPECT_LT(s[0].mean, 4.0);
    EXPECT_GT(s[3].mean, s[5].mean) << seed;
    EXPECT_GT(s[4].mean, s[5].mean) << seed;
    EXPECT_GT(s[7].mean, s[6].mean + 0.8) << seed;
    EXPECT_GT(s[6].mean, s[8].mean) << seed;
    EXPECT_LT(s[6].mean, s[8].mean + 0.8) << seed;
  }
}

TEST(DemonstrationTrainingMarks, AreWholePointsOnTheScaleAndReproducible) {
  const std::vector<TrainingMark> one = demonstrationTrainingMarks(kOneToTen, people(), 7);
  const std::vector<TrainingMark> two = demonstrationTrainingMarks(kOneToTen, people(), 7);
  const std::vector<TrainingMark> other = demonstrationTrainingMarks(kOneToTen, people(), 8);
  bool differs = false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].steps, two[i].steps);
    EXPECT_EQ(one[i].steps % 10, 0);
    EXPECT_GE(one[i].steps, 10);
    EXPECT_LE(one[i].steps, 100);
    differs = differs || one[i].steps != other[i].steps;
  }
  EXPECT_TRUE(differs);
}

TEST(DemonstrationEvaluationMarks, RankTheModelsAndFillEverySheet) {
  const EvaluationInstrument instrument = paperInstrument();
  const std::vector<std::string> models = {"PM", "FEM", "MSM"};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<ModelEvaluation> got =
        evaluate(instrument, demonstrationEvaluationMarks(instrument, people(), models, seed));
    ASSERT_EQ(got.size(), 3U);
    EXPECT_GT(got[0].n27, got[1].n27);
    EXPECT_GT(got[1].n27, got[2].n27);
    EXPECT_EQ(got[0].missing, 0);
    EXPECT_EQ(got[0].composites.size(), 40U);
  }
}

TEST(DemonstrationRules, StateThatNoConclusionMayBeDrawn) {
  EXPECT_THAT(demonstrationTrainingRule().str(), ::testing::HasSubstr("no conclusion about training"));
  EXPECT_THAT(demonstrationTrainingRule().str(), ::testing::HasSubstr("group 2: 1.7 and 4.1"));
  EXPECT_THAT(demonstrationEvaluationRule().str(), ::testing::HasSubstr("say nothing about any model"));
}

}  // namespace
}  // namespace torsio
