// SPDX-License-Identifier: GPL-3.0-or-later

#include "assessment/scoring/evaluation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/scoring/evaluation_kernel.h"
#include "assessment/scoring/evaluation_resampling.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "tests/assessment/reference_case.h"

namespace torsio {

namespace {

using test::matches;
using test::referenceCase;
using test::ReferenceCase;

// Exact values rounded once: got and expected are the same double.
constexpr double kSameDouble = 0.0;

double value(const nlohmann::json& exact) {
  return exact.at("float").get<double>();
}

EvaluationInstrument instrumentWith(const std::vector<double>& indexWeights) {
  EvaluationInstrument instrument = paperInstrument();
  instrument.indices.clear();
  const std::vector<std::int64_t> milli = weightsInMilli(indexWeights);
  for (std::size_t j = 0; j < milli.size(); ++j) {
    instrument.indices.push_back({std::to_string(j + 1), "", milli[j]});
  }
  return instrument;
}

/// scores[class][rater][index]; null is a missing mark.
ModelRatings ratingsFrom(const EvaluationInstrument& instrument, const nlohmann::json& byClass) {
  ModelRatings ratings{"PM", {}};
  for (std::size_t c = 0; c < instrument.classes.size(); ++c) {
    std::size_t number = 0;
    for (const nlohmann::json& row : byClass.at(instrument.classes[c].id)) {
      RaterSheet sheet{instrument.classes[c].id + std::to_string(++number), c, {}};
      for (const nlohmann::json& mark : row) {
        sheet.steps.push_back(std::nullopt);
        if (!mark.is_null()) {
          sheet.steps.back() = stepsFromPoints(mark.get<double>(), instrument.scale, "case");
        }
      }
      ratings.sheets.push_back(sheet);
    }
  }
  return ratings;
}

nlohmann::json oneIndex(const nlohmann::json& input) {
  nlohmann::json byClass;
  for (const char* id : {"A", "B", "C"}) {
    byClass[id] = nlohmann::json::array();
    for (const nlohmann::json& mark : input.at(id)) {
      byClass[id].push_back(nlohmann::json::array({mark}));
    }
  }
  return byClass;
}

void expectStatistics(const ScoreStatistics& got, const nlohmann::json& expected, double tolerance) {
  EXPECT_TRUE(matches(got.m, value(expected.at("M")), kSameDouble));
  EXPECT_TRUE(matches(got.s2, value(expected.at("s2_eq26")), kSameDouble));
  EXPECT_EQ(got.n, expected.at("n").get<std::int64_t>());
  EXPECT_TRUE(matches(got.plainMean, value(expected.at("unweighted_mean")), kSameDouble));
  EXPECT_TRUE(matches(got.populationVariance, value(expected.at("pop_var")), kSameDouble));
  ASSERT_TRUE(got.sampleVariance.has_value());
  EXPECT_TRUE(matches(*got.sampleVariance, value(expected.at("sample_var")), kSameDouble));
  EXPECT_TRUE(matches(got.classWeightedMoment, value(expected.at("s2_class_weighted")), kSameDouble));
  EXPECT_TRUE(matches(got.min, value(expected.at("min")), kSameDouble));
  EXPECT_TRUE(matches(got.max, value(expected.at("max")), kSameDouble));
  EXPECT_EQ(got.standardError.has_value(), !expected.at("se2_M").is_null());
  if (got.standardError) {
    EXPECT_TRUE(matches(*got.standardError * *got.standardError, value(expected.at("se2_M")), tolerance));
    EXPECT_TRUE(matches(got.standardErrorDf.value(), value(expected.at("df_M")), tolerance));
  }
  // Eq. 26 is the population variance plus the squared distance between the two means.
  const double shift = got.plainMean - got.m;
  EXPECT_NEAR(got.s2, got.populationVariance + shift * shift, 1e-12);
}

TEST(EvaluateModel, ReproducesExampleOneToTheLastDigit) {
  const ReferenceCase example = referenceCase("evaluation", "eq25_ex1");
  const EvaluationInstrument instrument = instrumentWith({1.0});

  const ModelEvaluation result = evaluateModel(instrument, ratingsFrom(instrument, oneIndex(example.input)));

  expectStatistics(result.indices[0], example.expected, example.tolerance);
  EXPECT_EQ(result.indices[0].m, 8.3);
  EXPECT_EQ(result.indices[0].s2, 1.61);
  EXPECT_THAT(result.indices[0].classCounts, ::testing::ElementsAre(2, 2, 1));
  EXPECT_EQ(result.indices[0].classMeans[1].value(), 8.0);
}

TEST(EvaluateModel, ReproducesExampleTwoWithMissingMarksToTheLastDigit) {
  const ReferenceCase example = referenceCase("evaluation", "eq25_ex2_missing");
  const EvaluationInstrument instrument = instrumentWith(test::numbers(example.input.at("index_weights")));
  nlohmann::json byClass;
  const nlohmann::json& indices = example.input.at("indices");
  for (const char* id : {"A", "B", "C"}) {
    for (std::size_t i = 0; i < indices[0].at(id).size(); ++i) {
      nlohmann::json row = nlohmann::json::array();
      for (const nlohmann::json& index : indices) {
        row.push_back(index.at(id)[i]);
      }
      byClass[id].push_back(row);
    }
  }
  const ModelRatings ratings = ratingsFrom(instrument, byClass);

  const ModelEvaluation result = evaluateModel(instrument, ratings);

  for (std::size_t j = 0; j < 3; ++j) {
    expectStatistics(result.indices[j], example.expected.at("indices")[j], example.tolerance);
  }
  EXPECT_TRUE(matches(result.n27, value(example.expected.at("N_eq27")), kSameDouble));
  EXPECT_EQ(result.missing, 2);
  EXPECT_THAT(result.flags, ::testing::ElementsAre("available-case"));
  EXPECT_TRUE(matches(result.compositeStatistics->m,
                      value(example.expected.at("N_from_complete_rater_composites")), kSameDouble));
  std::size_t at = 0;
  for (const char* id : {"A", "B", "C"}) {
    for (const nlohmann::json& composite : example.expected.at("rater_composites").at(id)) {
      const RaterComposite& got = result.composites[at++];
      EXPECT_EQ(got.score.has_value(), !composite.is_null());
      if (got.score) {
        EXPECT_TRUE(matches(*got.score, value(composite), kSameDouble));
      }
    }
  }
}

TEST(EvaluateModel, ReportsAnotherCompositeForListWiseDeletion) {
  const ReferenceCase example = referenceCase("evaluation", "eq25_ex2_missing");
  const EvaluationInstrument instrument = instrumentWith({0.5, 0.3, 0.2});
  ModelRatings ratings{"PM", {}};
  const nlohmann::json& indices = example.input.at("indices");
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < indices[0].at(instrument.classes[c].id).size(); ++i) {
      RaterSheet sheet{instrument.classes[c].id + std::to_string(i), c, {}};
      for (const nlohmann::json& index : indices) {
        const nlohmann::json& mark = index.at(instrument.classes[c].id)[i];
        sheet.steps.push_back(std::nullopt);
        if (!mark.is_null()) {
          sheet.steps.back() = stepsFromPoints(mark.get<double>(), instrument.scale, "");
        }
      }
      ratings.sheets.push_back(sheet);
    }
  }

  const ModelEvaluation result = evaluateModel(instrument, ratings, {.missing = MissingPolicy::kListWise});

  EXPECT_TRUE(
      matches(result.n27, value(example.expected.at("N_from_complete_rater_composites")), kSameDouble));
  EXPECT_THAT(result.flags, ::testing::Contains("list-wise"));
  EXPECT_THROW((void)evaluateModel(instrument, ratings, {.missing = MissingPolicy::kRefuse}), Error);
}

TEST(EvaluateModel, ReproducesExampleThreeToTheLastDigit) {
  const ReferenceCase example = referenceCase("evaluation", "eq25_ex3_20_10_10");
  const EvaluationInstrument instrument = paperInstrument();
  const auto shifted = [&](int model) {
    nlohmann::json byClass = example.input.at("scores_PM");
    for (const char* id : {"A", "B", "C"}) {
      for (std::size_t i = 0; i < byClass[id].size(); ++i) {
        for (std::size_t j = 0; j < 9; ++j) {
          // The rule stated by the case: FEM = b - 1 - (i + j) mod 2, MSM = b - 2 - (i + 2 j) mod 3.
          const int b = byClass[id][i][j].get<int>();
          const int rater = static_cast<int>(i) + 1;
          const int index = static_cast<int>(j) + 1;
          if (model == 1) {
            byClass[id][i][j] = b - 1 - (rater + index) % 2;
          }
          if (model == 2) {
            byClass[id][i][j] = b - 2 - (rater + 2 * index) % 3;
          }
        }
      }
    }
    return byClass;
  };
  const char* names[] = {"PM", "FEM", "MSM"};

  for (int model = 0; model < 3; ++model) {
    const nlohmann::json& expected = example.expected.at("models").at(names[model]);
    const ModelEvaluation result = evaluateModel(instrument, ratingsFrom(instrument, shifted(model)));

    ASSERT_EQ(result.indices.size(), 9U);
    for (std::size_t j = 0; j < 9; ++j) {
      expectStatistics(result.indices[j], expected.at("indices")[j], example.tolerance);
    }
    EXPECT_TRUE(matches(result.n27, value(expected.at("N_eq27")), kSameDouble));
    expectStatistics(*result.compositeStatistics, expected.at("composite_stats"), example.tolerance);
    std::size_t at = 0;
    for (const char* id : {"A", "B", "C"}) {
      for (const nlohmann::json& composite : expected.at("rater_composites").at(id)) {
        EXPECT_TRUE(matches(result.composites[at++].score.value(), composite.get<double>(), kSameDouble));
      }
    }
    EXPECT_TRUE(result.flags.empty());
  }
}

TEST(EvaluateModel, RejectsAnEmptyWeightedClassOrRenormalisesOnRequest) {
  const ReferenceCase example = referenceCase("evaluation", "eq25_edge_empty_class");
  const EvaluationInstrument instrument = instrumentWith({1.0});
  const ModelRatings ratings = ratingsFrom(instrument, oneIndex(example.input));

  try {
    (void)evaluateModel(instrument, ratings);
    FAIL() << "class C is empty";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("class C has no ratings"));
  }
  const ModelEvaluation result = evaluateModel(instrument, ratings, {.missing = MissingPolicy::kRenormalise});

  EXPECT_EQ(result.indices[0].m, 7.6);
  EXPECT_EQ(result.indices[0].s2, 1.26);
  EXPECT_THAT(result.flags, ::testing::Contains("renormalised"));
  EXPECT_THAT(result.indices[0].flags, ::testing::Contains("renormalised"));
}

TEST(StepsFromText, AcceptsOnlyStepsOfTheScale) {
  const ScoreScale zeroToTen{0, 100, 10};
  const ScoreScale oneToTen{10, 100, 10};

  EXPECT_EQ(stepsFromText("10", zeroToTen, ""), 100);
  EXPECT_EQ(stepsFromText("0.0", zeroToTen, ""), 0);
  EXPECT_EQ(stepsFromText("7.30", zeroToTen, ""), 73);
  for (const char* bad :
       {"10.0000001", "-0.5", "nan", "inf", "7,5", "", "1e1", "7.25", "ten", "10.1", "1.2.3"}) {
    EXPECT_THROW((void)stepsFromText(bad, zeroToTen, "line 3"), Error) << bad;
  }
  EXPECT_THROW((void)stepsFromText("0", oneToTen, ""), Error);
}

TEST(StepsFromPoints, FollowsTheValidationTable) {
  const ReferenceCase rules = referenceCase("evaluation", "eq25_edge_validation");
  for (const nlohmann::json& rule : rules.input.at("cases")) {
    const nlohmann::json& score = rule.at("score");
    const double points = score.is_number() ? score.get<double>()
                          : score == "nan"  ? std::numeric_limits<double>::quiet_NaN()
                                            : std::numeric_limits<double>::infinity();
    ScoreScale scale;
    if (rule.contains("scale")) {
      scale.lo = rule.at("scale")[0].get<std::int64_t>() * scale.stepsPerPoint;
    }
    if (rule.at("ok").get<bool>()) {
      EXPECT_NO_THROW((void)stepsFromPoints(points, scale, "")) << rule;
    } else {
      EXPECT_THROW((void)stepsFromPoints(points, scale, ""), Error) << rule;
    }
  }
  for (const nlohmann::json& rule : rules.input.at("weights")) {
    if (rule.at("ok").get<bool>()) {
      EXPECT_NO_THROW((void)weightsInMilli(test::numbers(rule.at("w")))) << rule;
    } else {
      EXPECT_THROW((void)weightsInMilli(test::numbers(rule.at("w"))), Error) << rule;
    }
  }
}

TEST(GroupRatings, RejectsDuplicatesForeignClassesAndMarksOffTheScale) {
  const EvaluationInstrument instrument = paperInstrument();
  const EvaluationRating good{"PM", "r1", 0, 0, 70};

  EXPECT_THROW((void)groupRatings(instrument, std::vector<EvaluationRating>{good, good}), Error);
  EXPECT_THROW((void)groupRatings(instrument, std::vector<EvaluationRating>{good, {"PM", "r1", 1, 1, 70}}),
               Error);
  EXPECT_THROW((void)groupRatings(instrument, std::vector<EvaluationRating>{{"PM", "r1", 0, 0, 101}}), Error);
  EXPECT_THROW((void)groupRatings(instrument, std::vector<EvaluationRating>{{"PM", "r1", 3, 0, 50}}), Error);
  EXPECT_EQ(groupRatings(instrument, std::vector<EvaluationRating>{good, {"FEM", "r1", 0, 0, 60}}).size(),
            2U);
}

}  // namespace

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
