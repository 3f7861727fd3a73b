// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of Eqs. 25 to 27 that hold for any marks.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/scoring/evaluation.h"
#include "assessment/scoring/evaluation_kernel.h"
#include "sim/core/random.h"

namespace torsio {
namespace {

/// Random complete marks for classes of the given sizes; steps between 20 and 80.
ModelRatings randomRatings(Random& random, const EvaluationInstrument& instrument,
                           const std::vector<std::size_t>& sizes) {
  ModelRatings ratings{"PM", {}};
  for (std::size_t c = 0; c < sizes.size(); ++c) {
    for (std::size_t i = 0; i < sizes[c]; ++i) {
      RaterSheet sheet{std::to_string(1000 * c + i), c, {}};
      for (std::size_t j = 0; j < instrument.indices.size(); ++j) {
        sheet.steps.push_back(20 + static_cast<std::int64_t>(random.bounded(61)));
      }
      ratings.sheets.push_back(sheet);
    }
  }
  return ratings;
}

TEST(EvaluateModel, IsIndependentOfTheOrderOfRaters) {
  Random random(11);
  const EvaluationInstrument instrument = paperInstrument();
  ModelRatings ratings = randomRatings(random, instrument, {20, 10, 10});
  const ModelEvaluation before = evaluateModel(instrument, ratings);

  random.shuffle(std::span<RaterSheet>(ratings.sheets));
  const ModelEvaluation after = evaluateModel(instrument, ratings);

  EXPECT_EQ(before.n27, after.n27);
  for (std::size_t j = 0; j < 9; ++j) {
    EXPECT_EQ(before.indices[j].m, after.indices[j].m);
    EXPECT_EQ(before.indices[j].s2, after.indices[j].s2);
  }
}

TEST(EvaluateModel, ShiftsAndScalesLikeItsFormulas) {
  Random random(12);
  const EvaluationInstrument instrument = paperInstrument();
  const ModelRatings ratings = randomRatings(random, instrument, {7, 5, 3});
  ModelRatings shifted = ratings;
  ModelRatings doubled = ratings;
  EvaluationInstrument wide = instrument;
  wide.scale.hi = 200;
  for (std::size_t i = 0; i < ratings.sheets.size(); ++i) {
    for (std::size_t j = 0; j < 9; ++j) {
      *shifted.sheets[i].steps[j] += 10;  // one point
      *doubled.sheets[i].steps[j] *= 2;
    }
  }

  const ModelEvaluation base = evaluateModel(instrument, ratings);
  const ModelEvaluation plusOne = evaluateModel(wide, shifted);
  const ModelEvaluation twice = evaluateModel(wide, doubled);

  constexpr double kRounding = 1e-14;  // adding 1 to a rounded value rounds once more
  EXPECT_NEAR(plusOne.n27, base.n27 + 1.0, 10 * kRounding);
  EXPECT_DOUBLE_EQ(twice.n27, 2.0 * base.n27);
  for (std::size_t j = 0; j < 9; ++j) {
    EXPECT_EQ(plusOne.indices[j].s2, base.indices[j].s2);
    EXPECT_EQ(twice.indices[j].s2, 4.0 * base.indices[j].s2);
    EXPECT_EQ(twice.indices[j].m, 2.0 * base.indices[j].m);
  }
}

TEST(EvaluateModel, GivesPlainMeanAndVarianceIfWeightsFollowTheClassSizes) {
  Random random(13);
  EvaluationInstrument instrument = paperInstrument();
  instrument.classes[0].weight_milli = 500;
  instrument.classes[1].weight_milli = 250;
  instrument.classes[2].weight_milli = 250;

  const ModelEvaluation result = evaluateModel(instrument, randomRatings(random, instrument, {20, 10, 10}));

  for (const ScoreStatistics& index : result.indices) {
    EXPECT_EQ(index.m, index.plainMean);
    EXPECT_EQ(index.s2, index.populationVariance);
  }
}

TEST(EvaluateModel, KeepsTheComprehensiveScoreBetweenTheIndicesAndEqualToTheCompositeMean) {
  Random random(14);
  const EvaluationInstrument instrument = paperInstrument();
  for (int repeat = 0; repeat < 50; ++repeat) {
    const std::vector<std::size_t> sizes = {1 + random.bounded(20), 1 + random.bounded(12),
                                            1 + random.bounded(12)};
    const ModelEvaluation result = evaluateModel(instrument, randomRatings(random, instrument, sizes));

    double low = 100.0;
    double high = 0.0;
    for (const ScoreStatistics& index : result.indices) {
      low = std::min(low, index.m);
      high = std::max(high, index.m);
      EXPECT_GE(index.s2, index.populationVariance);
    }
    EXPECT_LE(low, result.n27);
    EXPECT_GE(high, result.n27);
    EXPECT_EQ(result.n27, result.compositeStatistics->m);  // both are the same fraction, rounded once
  }
}

TEST(EvaluateModel, StaysExactIfTheClassSizesShareNoDivisor) {
  // Class sizes 97, 89, 83: numerators exceed 2^53, which takes the arbitrary-precision path.
  Random random(15);
  const EvaluationInstrument instrument = paperInstrument();
  const ModelRatings ratings = randomRatings(random, instrument, {97, 89, 83});

  const ModelEvaluation result = evaluateModel(instrument, ratings);

  for (std::size_t j = 0; j < 9; ++j) {
    long double m = 0.0L;
    for (std::size_t c = 0; c < 3; ++c) {
      long double sum = 0.0L;
      long double n = 0.0L;
      for (const RaterSheet& sheet : ratings.sheets) {
        if (sheet.raterClass == c) {
          sum += static_cast<long double>(*sheet.steps[j]) / 10.0L;
          n += 1.0L;
        }
      }
      m += static_cast<long double>(instrument.classes[c].weight_milli) / 1000.0L * sum / n;
    }
    EXPECT_NEAR(result.indices[j].m, static_cast<double>(m), 1e-14);
    EXPECT_GE(result.indices[j].s2, result.indices[j].populationVariance);
  }
  EXPECT_EQ(result.n27, result.compositeStatistics->m);
}

TEST(EvaluateModel, LeavesTheStandardErrorUndefinedForASingleRaterInAClass) {
  Random random(16);
  const EvaluationInstrument instrument = paperInstrument();

  const ModelEvaluation one = evaluateModel(instrument, randomRatings(random, instrument, {3, 2, 1}));
  ModelRatings constant = randomRatings(random, instrument, {3, 2, 2});
  for (RaterSheet& sheet : constant.sheets) {
    std::fill(sheet.steps.begin(), sheet.steps.end(), 70);
  }
  const ModelEvaluation same = evaluateModel(instrument, constant);

  EXPECT_FALSE(one.indices[0].standardError.has_value());
  EXPECT_EQ(same.indices[0].s2, 0.0);
  EXPECT_EQ(same.indices[0].standardError.value(), 0.0);
  EXPECT_FALSE(same.indices[0].standardErrorDf.has_value());
}

TEST(EvaluateModel, IgnoresAClassOfWeightZeroByDefault) {
  Random random(17);
  EvaluationInstrument instrument = paperInstrument();
  instrument.classes[0].weight_milli = 0;
  instrument.classes[1].weight_milli = 500;
  const ModelRatings ratings = randomRatings(random, instrument, {4, 3, 3});

  const ModelEvaluation without = evaluateModel(instrument, ratings);
  const ModelEvaluation with = evaluateModel(instrument, ratings, {.zeroWeightClassesInVariance = true});

  EXPECT_EQ(without.indices[0].n, 6);
  EXPECT_EQ(with.indices[0].n, 10);
  EXPECT_EQ(without.indices[0].m, with.indices[0].m);
}

TEST(EvaluationKernel, GivesTheSameBitsAsTheFullEvaluation) {
  Random random(18);
  const EvaluationInstrument instrument = paperInstrument();
  const ModelRatings ratings = randomRatings(random, instrument, {20, 10, 10});
  const ModelEvaluation expected = evaluateModel(instrument, ratings);
  std::vector<std::size_t> classes;
  std::vector<std::int64_t> steps;
  for (const RaterSheet& sheet : ratings.sheets) {
    classes.push_back(sheet.raterClass);
    for (const std::optional<std::int64_t>& mark : sheet.steps) {
      steps.push_back(*mark);
    }
  }
  std::vector<double> m(9);
  std::vector<double> s2(9);

  const double n = EvaluationKernel(instrument, classes).run(steps, m, s2);

  EXPECT_EQ(n, expected.n27);
  for (std::size_t j = 0; j < 9; ++j) {
    EXPECT_EQ(m[j], expected.indices[j].m);
    EXPECT_EQ(s2[j], expected.indices[j].s2);
  }
}

}  // namespace
}  // namespace torsio
