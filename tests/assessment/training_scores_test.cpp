// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/training_scores.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using test::matches;

const ScoreScale kWholePoints{1, 10, 1};

std::string code(char letter, std::size_t number) {
  std::string text(1, letter);
  text += std::to_string(number);
  return text;
}

std::vector<TrainingMark> syntheticStudy() {
  const nlohmann::json data =
      test::referenceCase("training_study", "training_study_synthetic").input.at("data_g_i_t_r");
  std::vector<TrainingMark> marks;
  for (std::size_t g = 0; g < 3; ++g) {
    for (std::size_t i = 0; i < 10; ++i) {
      for (std::size_t t = 0; t < 3; ++t) {
        for (std::size_t r = 0; r < 10; ++r) {
          marks.push_back(
              {code('G', 100 * (g + 1) + i), g, t, code('R', r), data[g][i][t][r].get<std::int64_t>()});
        }
      }
    }
  }
  return marks;
}

TEST(GroupSummaries, ReproducesTheTableOfTheSyntheticStudyToTheLastDigit) {
  const nlohmann::json expected =
      test::referenceCase("training_study", "training_study_synthetic").expected.at("descriptives");

  const std::vector<GroupSummary> got = groupSummaries(kWholePoints, syntheticStudy());

  ASSERT_EQ(got.size(), 9U);
  for (const nlohmann::json& row : expected) {
    const auto g = row.at("group").get<std::size_t>() - 1;
    const auto t = row.at("t").get<std::size_t>();
    const GroupSummary& summary = got[t * 3 + g];
    ASSERT_EQ(summary.group, g);
    ASSERT_EQ(summary.occasion, t);
    EXPECT_EQ(summary.mean, row.at("mean").get<double>());
    EXPECT_EQ(summary.varianceOfScores, row.at("var_n").get<double>());
    EXPECT_TRUE(matches(summary.sampleVarianceOfScores.value(), row.at("var_nm1").get<double>(), 1e-15));
    EXPECT_EQ(summary.trainees, 10);
    EXPECT_EQ(summary.marks, 100);
  }
  // Group 2 before training: row of the worked table (mean 5.05, all marks 2.3675, between raters .563333,
  // 3..7, 5).
  const GroupSummary& second = got[1];
  EXPECT_EQ(second.varianceOfMarks, 2.3675);
  EXPECT_NEAR(second.meanBetweenRaterVariance.value(), 0.563333333333, 1e-12);
  EXPECT_EQ(second.min, 3.0);
  EXPECT_EQ(second.max, 7.0);
  EXPECT_EQ(second.median, 5.0);
  EXPECT_EQ(got[3].median, 6.45);
  EXPECT_EQ(got[8].varianceOfMarks, 1.86);
}

TEST(TraineeScores, AreTheMeansOverTheRatersOrderedByCode) {
  const nlohmann::json expected =
      test::referenceCase("training_study", "training_study_synthetic").expected.at("intern_scores_g_i_t");

  const std::vector<TraineeScore> scores = traineeScores(kWholePoints, syntheticStudy());

  ASSERT_EQ(scores.size(), 90U);
  for (const TraineeScore& score : scores) {
    EXPECT_EQ(score.score, expected[score.group][score.number - 1][score.occasion].get<double>());
  }
}

TEST(ExactGains, PreserveTiesThatDifferencesOfDoublesBreak) {
  const std::vector<TraineeScore> scores = traineeScores(kWholePoints, syntheticStudy());

  const std::optional<std::vector<std::int64_t>> gains = exactGains(scores, 0, 2, 0);

  ASSERT_TRUE(gains.has_value());
  // Ten raters: tenths of a point. First row of gain_scores.gains in the case.
  EXPECT_THAT(*gains, ::testing::ElementsAre(21, 20, 19, 18, 20, 19, 19, 16, 22, 19));
}

TEST(TraineeScores, RejectsDuplicatesForeignGroupsAndMarksOffTheScale) {
  const TrainingMark good{"G1-01", 0, 0, "R1", 5};

  EXPECT_THROW((void)traineeScores(kWholePoints, std::vector<TrainingMark>{good, good}), Error);
  EXPECT_THROW((void)traineeScores(kWholePoints, std::vector<TrainingMark>{good, {"G1-01", 1, 1, "R1", 5}}),
               Error);
  EXPECT_THROW((void)traineeScores(kWholePoints, std::vector<TrainingMark>{{"G1-01", 0, 0, "R1", 0}}), Error);
}

TEST(GroupSummaries, UsesTheMarksGivenIfARaterIsMissing) {
  // Trainee a: marks 4 and 5, mean 4.5; trainee b: mark 6. Mean 5.25, variance (0.75^2 + 0.75^2) / 2 =
  // 0.5625.
  const std::vector<TrainingMark> marks = {{"a", 0, 0, "R1", 4}, {"a", 0, 0, "R2", 5}, {"b", 0, 0, "R1", 6}};

  const std::vector<GroupSummary> got = groupSummaries(kWholePoints, marks);

  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].mean, 5.25);
  EXPECT_EQ(got[0].varianceOfScores, 0.5625);
  EXPECT_EQ(got[0].sampleVarianceOfScores.value(), 1.125);
  EXPECT_FALSE(got[0].meanBetweenRaterVariance.has_value());
}

}  // namespace
}  // namespace torsio
