// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/evaluation_resampling.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/scoring/evaluation.h"
#include "sim/core/error.h"

namespace torsio {
namespace {

/// One index, class A with weight 1, class B with weight 0; in points.
ModelRatings twoClasses(const std::vector<double>& ofA, const std::vector<double>& ofB) {
  ModelRatings ratings{"PM", {}};
  const auto add = [&](const std::vector<double>& points, std::size_t raterClass) {
    for (const double point : points) {
      ratings.sheets.push_back(
          {std::string(1, static_cast<char>('A' + raterClass)) + std::to_string(ratings.sheets.size()),
           raterClass,
           {std::llround(10.0 * point)}});
    }
  };
  add(ofA, 0);
  add(ofB, 1);
  return ratings;
}

EvaluationInstrument onlyIndex() {
  EvaluationInstrument instrument = paperInstrument();
  instrument.indices.resize(1);
  instrument.indices[0].weight_milli = 1000;
  instrument.classes.resize(2);
  instrument.classes[0].weight_milli = 1000;
  instrument.classes[1].weight_milli = 0;
  return instrument;
}

TEST(ResampledScore, IsTheMiddleOfTheResampledPanels) {
  // Two raters with 6 and 8: a resampled panel gives 6, 7 or 8 with probabilities 1/4, 1/2, 1/4, so the
  // middle 95 % are 6 to 8, whatever a class of weight 0 says.
  const ScoreRange two = resampledScore(onlyIndex(), twoClasses({6, 8}, {1}), {.resamples = 2000, .seed = 3});
  EXPECT_EQ(two.lower, 6.0);
  EXPECT_EQ(two.upper, 8.0);

  // Forty with 4 and forty with 6: the mean of 80 has standard error 1 / sqrt(80) = 0.1118, so 5 -+ 1.96 x
  // 0.1118 = 4.78 and 5.22, up to a mark of 0.025 and the error of 20,000 draws.
  std::vector<double> many(40, 4.0);
  many.resize(80, 6.0);
  const ScoreRange wide = resampledScore(onlyIndex(), twoClasses(many, {}), {.resamples = 20'000});
  EXPECT_NEAR(wide.lower, 4.78, 0.03);
  EXPECT_NEAR(wide.upper, 5.22, 0.03);
}

TEST(ResampledScore, SupportsClassSizesWithoutACommonMultiple) {
  // 97 x 101 x 103 panels have no common denominator below a million; for 31, 29 and 23 its squares do not
  // fit a double.
  for (const std::vector<int>& sizes : {std::vector<int>{97, 101, 103}, std::vector<int>{31, 29, 23}}) {
    EvaluationInstrument instrument = paperInstrument();
    instrument.indices.resize(1);
    instrument.indices[0].weight_milli = 1000;
    ModelRatings ratings{"PM", {}};
    for (std::size_t c = 0; c < 3; ++c) {
      for (int i = 0; i < sizes[c]; ++i) {
        ratings.sheets.push_back(
            {std::string(1, static_cast<char>('A' + c)) + std::to_string(i), c, {40 + 20 * (i % 2)}});
      }
    }
    const ScoreRange range = resampledScore(instrument, ratings, {.resamples = 400});
    const double n = evaluateModel(instrument, ratings).n27;
    EXPECT_LT(range.lower, n);
    EXPECT_GT(range.upper, n);
    // Equal numbers of 4 and 6: the standard error of N is the root of the sum of w^2 / n.
    double variance = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double weight = static_cast<double>(instrument.classes[c].weight_milli) / 1000.0;
      variance += weight * weight / sizes[c];
    }
    EXPECT_NEAR(0.5 * (range.upper - range.lower), 1.96 * std::sqrt(variance), 0.4 * std::sqrt(variance));
  }
}

TEST(ResampledScore, RejectsMissingMarksAndEmptyClasses) {
  ModelRatings hole = twoClasses({6, 8}, {});
  hole.sheets[0].steps[0].reset();
  EXPECT_THROW((void)resampledScore(onlyIndex(), hole), Error);
  EXPECT_THROW((void)resampledScore(onlyIndex(), twoClasses({}, {5})), Error);
  EXPECT_THROW((void)resampledScore(onlyIndex(), twoClasses({6}, {}), {.resamples = 0}), Error);
}

}  // namespace
}  // namespace torsio
