// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/generalizability.h"
#include "assessment/statistics/reliability.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using Rows = std::vector<std::vector<double>>;
using test::matches;
using test::numbers;
using test::ReferenceCase;
using test::referenceCase;

NumberTable tableOf(const nlohmann::json& rows) {
  return NumberTable(rows.get<std::vector<std::vector<double>>>());
}

IncompleteRatings incomplete(const nlohmann::json& coders) {
  IncompleteRatings out;
  for (const nlohmann::json& coder : coders) {
    out.emplace_back();
    for (const nlohmann::json& value : coder) {
      out.back().push_back(std::nullopt);
      if (!value.is_null()) {
        out.back().back() = value.get<double>();
      }
    }
  }
  return out;
}

void expectIcc(const IccResult& got, const nlohmann::json& expected, double tolerance) {
  const std::vector<std::pair<const char*, const IccForm*>> forms = {
      {"ICC1", &got.oneWaySingle}, {"ICC2", &got.agreementSingle}, {"ICC3", &got.consistencySingle},
      {"ICC1k", &got.oneWayMean},  {"ICC2k", &got.agreementMean},  {"ICC3k", &got.consistencyMean}};
  for (const auto& [name, form] : forms) {
    EXPECT_TRUE(matches(form->estimate, expected.at("ICC").at(name).get<double>(), tolerance)) << name;
    const std::vector<double> interval = numbers(expected.at("CI95").at(name));
    EXPECT_TRUE(matches(form->interval.value().lower, interval[0], tolerance)) << name;
    EXPECT_TRUE(matches(form->interval.value().upper, interval[1], tolerance)) << name;
  }
  for (const auto& [name, value] :
       std::vector<std::pair<const char*, double>>{{"BMS", got.bms},
                                                   {"WMS", got.wms},
                                                   {"JMS", got.jms},
                                                   {"EMS", got.ems},
                                                   {"v_df", got.agreementDf},
                                                   {"F_oneway", got.fOneWay.value()},
                                                   {"p_oneway", got.pOneWay.value()},
                                                   {"F_twoway", got.fTwoWay.value()},
                                                   {"p_twoway", got.pTwoWay.value()}}) {
    EXPECT_TRUE(matches(value, expected.at(name).get<double>(), tolerance)) << name;
  }
}

TEST(IntraclassCorrelation, AgreesWithShroutAndFleiss) {
  const ReferenceCase c = referenceCase("agreement", "icc_shrout_fleiss_1979");
  const Outcome<IccResult> got = intraclassCorrelation(tableOf(c.input.at("ratings_target_by_judge")));
  ASSERT_TRUE(got);
  expectIcc(*got, c.expected, c.tolerance);
  EXPECT_TRUE(matches(got->varianceTargets, c.expected.at("var_subject").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->varianceRaters, c.expected.at("var_rater").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->varianceResidual, c.expected.at("var_resid").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->semConsistency, c.expected.at("SEM_consistency").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->semAgreement, c.expected.at("SEM_agreement").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->fRaters.value(), c.expected.at("F_raters").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->pRaters.value(), c.expected.at("p_raters").get<double>(), c.tolerance));
}

TEST(IntraclassCorrelation, AgreesOnTheAnxietyRatings) {
  const ReferenceCase c = referenceCase("agreement", "icc_anxiety");
  const Outcome<IccResult> got = intraclassCorrelation(tableOf(c.input.at("ratings_subject_by_rater")));
  ASSERT_TRUE(got);
  expectIcc(*got, c.expected, c.tolerance);
}

TEST(IntraclassCorrelation, AgreesOnEveryOccasionOfTheSyntheticStudy) {
  const ReferenceCase c = referenceCase("training_study", "training_study_synthetic");
  for (std::size_t t = 0; t < 3; ++t) {
    std::vector<std::vector<double>> rows;
    for (const nlohmann::json& group : c.input.at("data_g_i_t_r")) {
      for (const nlohmann::json& trainee : group) {
        rows.push_back(numbers(trainee[t]));
      }
    }
    const Outcome<IccResult> got = intraclassCorrelation(NumberTable(rows));
    const nlohmann::json& expected = c.expected.at("icc_per_occasion_pre_mid_post")[t];
    EXPECT_TRUE(matches(got->agreementSingle.estimate, expected.at("ICC2").get<double>(), 1e-9));
    EXPECT_TRUE(matches(got->agreementMean.estimate, expected.at("ICC2k").get<double>(), 1e-9));
    EXPECT_TRUE(matches(got->oneWaySingle.estimate, expected.at("ICC1").get<double>(), 1e-9));
    EXPECT_TRUE(matches(got->consistencyMean.estimate, expected.at("ICC3k").get<double>(), 1e-9));
  }
}

TEST(IntraclassCorrelation, IsUndefinedWithoutVariationWithAReason) {
  EXPECT_THAT(intraclassCorrelation(NumberTable({{5, 5}, {5, 5}})).reason().str(),
              ::testing::HasSubstr("same"));
  EXPECT_FALSE(intraclassCorrelation(NumberTable(Rows{{1, 2}})));
  EXPECT_FALSE(intraclassCorrelation(NumberTable(Rows{{1}, {2}})));
  EXPECT_FALSE(intraclassCorrelation(NumberTable({{1e200, 0.0}, {0.0, 1e200}})));
  EXPECT_THAT(intraclassCorrelation(NumberTable({{1, 2}, {2, 1}})).reason().str(),
              ::testing::HasSubstr("targets"));
}

TEST(IntraclassCorrelation, HasNoIntervalIfItsDegreesOfFreedomVanish) {
  const Outcome<IccResult> icc = intraclassCorrelation(NumberTable(Rows{{0.0, 5.0, 8.0}, {2.0, 7.0, 5.0}}));

  ASSERT_TRUE(icc);
  EXPECT_LT(icc->agreementDf, 0.01);
  EXPECT_NEAR(icc->agreementSingle.estimate, -4.0 / 30.0, 1e-12);
  EXPECT_FALSE(icc->agreementSingle.interval);
  EXPECT_FALSE(icc->agreementMean.interval);
}

TEST(IntraclassCorrelation, HasNoIntervalIfThatOfTheMeanIsUnbounded) {
  const Outcome<IccResult> got = intraclassCorrelation(NumberTable({{8, 8}, {3, 10}}));
  ASSERT_TRUE(got);
  EXPECT_NEAR(got->agreementMean.estimate, -10.0 / 2.25, 1e-12);
  EXPECT_FALSE(got->agreementSingle.interval);
  EXPECT_FALSE(got->agreementMean.interval);
}

TEST(IntraclassCorrelation, OfRatersThatDifferByAConstantLacksOnlyRatiosToTheResidual) {
  const Outcome<IccResult> got = intraclassCorrelation(NumberTable({{1, 2}, {2, 3}, {3, 4}}));

  // Mean squares: targets 2, raters 1.5, residual 0. Agreement 2 / (2 + 2 x 1.5 / 3), like R's irr::icc.
  ASSERT_TRUE(got);
  EXPECT_DOUBLE_EQ(got->agreementSingle.estimate, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(got->agreementMean.estimate, 0.8);
  EXPECT_DOUBLE_EQ(got->consistencySingle.estimate, 1.0);
  EXPECT_FALSE(got->consistencySingle.interval);
  EXPECT_FALSE(got->agreementSingle.interval);
  EXPECT_FALSE(got->fTwoWay);
  EXPECT_TRUE(got->fOneWay);
  EXPECT_DOUBLE_EQ(intraclassCorrelation(NumberTable({{1, 1}, {2, 2}}))->oneWaySingle.estimate, 1.0);
}

TEST(KrippendorffAlpha, AgreesWithTheTextbookDataForAllMetrics) {
  const ReferenceCase c = referenceCase("agreement", "kripp_textbook");
  const IncompleteRatings ratings = incomplete(c.input.at("coder_by_unit_null_missing"));
  for (const auto& [name, metric] :
       std::vector<std::pair<const char*, AlphaMetric>>{{"nominal", AlphaMetric::kNominal},
                                                        {"ordinal", AlphaMetric::kOrdinal},
                                                        {"interval", AlphaMetric::kInterval},
                                                        {"ratio", AlphaMetric::kRatio}}) {
    const Outcome<KrippendorffResult> got = krippendorffAlpha(ratings, metric);
    const nlohmann::json& expected = c.expected.at(name);
    EXPECT_TRUE(matches(got->alpha, expected.at("alpha").get<double>(), c.tolerance)) << name;
    EXPECT_TRUE(matches(got->observed, expected.at("Do").get<double>(), c.tolerance)) << name;
    EXPECT_TRUE(matches(got->expected, expected.at("De").get<double>(), c.tolerance)) << name;
    EXPECT_EQ(got->pairable, expected.at("n_pairable").get<std::int64_t>());
  }
}

/// Squared difference of two ratings by the definition: for ranks, the number of ratings from one to the
/// other, the ends counted half.
double definedDifference2(AlphaMetric metric, double a, double b, const std::vector<double>& all) {
  if (metric == AlphaMetric::kNominal) {
    return a == b ? 0.0 : 1.0;
  }
  if (metric == AlphaMetric::kRatio) {
    return (a - b) * (a - b) / ((a + b) * (a + b));
  }
  if (metric == AlphaMetric::kInterval || a == b) {
    return (a - b) * (a - b);
  }
  double between = 0.0;
  for (const double x : all) {
    const bool inside = x > std::min(a, b) && x < std::max(a, b);
    between += inside ? 1.0 : (x == a || x == b) ? 0.5 : 0.0;
  }
  return between * between;
}

TEST(KrippendorffAlpha, MatchesItsDefinitionOnContinuousScoresWithGaps) {
  Random random(11);
  IncompleteRatings ratings(4, std::vector<std::optional<double>>(9));
  for (auto& coder : ratings) {
    for (auto& score : coder) {
      const bool given = random.bounded(4) > 0;
      score = given ? std::optional<double>(0.5 * static_cast<double>(1 + random.bounded(17))) : std::nullopt;
    }
  }
  std::vector<std::vector<double>> units(9);
  std::vector<double> all;
  for (std::size_t u = 0; u < units.size(); ++u) {
    for (const auto& coder : ratings) {
      if (coder[u]) {
        units[u].push_back(*coder[u]);
      }
    }
    if (units[u].size() > 1) {
      all.insert(all.end(), units[u].begin(), units[u].end());
    }
  }
  const double n = static_cast<double>(all.size());

  for (const AlphaMetric metric :
       {AlphaMetric::kNominal, AlphaMetric::kOrdinal, AlphaMetric::kInterval, AlphaMetric::kRatio}) {
    double observed = 0.0;
    for (const std::vector<double>& unit : units) {
      for (std::size_t i = 0; unit.size() > 1 && i < unit.size(); ++i) {
        for (const double other : unit) {
          observed +=
              definedDifference2(metric, unit[i], other, all) / (n * static_cast<double>(unit.size() - 1));
        }
      }
    }
    double expected = 0.0;
    for (const double a : all) {
      for (const double b : all) {
        expected += definedDifference2(metric, a, b, all) / (n * (n - 1.0));
      }
    }

    const Outcome<KrippendorffResult> got = krippendorffAlpha(ratings, metric);

    EXPECT_NEAR(got->observed, observed, 1e-12 * observed);
    EXPECT_NEAR(got->expected, expected, 1e-12 * expected);
    EXPECT_NEAR(got->alpha, 1.0 - observed / expected, 1e-12);
  }
}

TEST(KrippendorffAlpha, HandlesThousandsOfDistinctScoresAndRefusesOverflowingSquares) {
  Random random(3);
  IncompleteRatings ratings(10, std::vector<std::optional<double>>(800));
  for (std::size_t u = 0; u < 800; ++u) {
    const double truth = random.uniform();
    for (auto& coder : ratings) {
      coder[u] = truth + 0.5 * random.uniform();
    }
  }

  // Variance of the units 1/12, of a rating within them 1/48: alpha is near 0.8.
  EXPECT_NEAR(krippendorffAlpha(ratings, AlphaMetric::kInterval)->alpha, 0.8, 0.02);
  EXPECT_NEAR(krippendorffAlpha(ratings, AlphaMetric::kOrdinal)->alpha, 0.8, 0.03);
  EXPECT_NEAR(krippendorffAlpha(ratings, AlphaMetric::kNominal)->alpha, 0.0, 0.01);
  EXPECT_FALSE(
      krippendorffInterval(ratings, AlphaMetric::kRatio, 1, 99));  // 8,000 values squared per resample
  EXPECT_FALSE(krippendorffAlpha({{1e200, -1e200}, {1e200, 2e200}}, AlphaMetric::kInterval));
}

/// Expected disagreement on a ratio scale, pair by pair.
double expectedRatio(const IncompleteRatings& ratings) {
  std::vector<double> all;
  for (const auto& coder : ratings) {
    for (const std::optional<double>& value : coder) {
      all.push_back(value.value());
    }
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double ratio = all[i] + all[j] == 0.0 ? 0.0 : (all[i] - all[j]) / (all[i] + all[j]);
      sum += 2.0 * ratio * ratio;
    }
  }
  const double n = static_cast<double>(all.size());
  return sum / (n * (n - 1.0));
}

TEST(KrippendorffAlpha, OfARatioScaleMatchesTheSumOverPairs) {
  const auto ratings = [](const std::function<double(Random&)>& draw) {
    Random random(11);
    IncompleteRatings out(3, std::vector<std::optional<double>>(900));
    for (auto& coder : out) {
      for (std::optional<double>& value : coder) {
        value = draw(random);
      }
    }
    return out;
  };
  for (const IncompleteRatings& of :
       {ratings([](Random& random) { return 10.0 * random.uniform(); }),
        ratings([](Random& random) { return 1000.0 + 0.1 * random.uniform(); }),
        ratings([](Random& random) { return std::exp(40.0 * (random.uniform() - 0.5)); }),
        ratings([](Random& random) { return random.uniform() < 0.1 ? 0.0 : 0.5 + random.uniform(); }),
        ratings(
            [](Random& random) { return random.uniform() < 0.5 ? 1.0 + 1e-6 * random.uniform() : 1e6; })}) {
    const double expected = expectedRatio(of);
    EXPECT_NEAR(krippendorffAlpha(of, AlphaMetric::kRatio)->expected / expected, 1.0, 1e-10);
  }
}

TEST(KrippendorffAlpha, AgreesOnCompleteDataOfThreeRaters) {
  const ReferenceCase c = referenceCase("agreement", "kripp_complete_data");
  const IncompleteRatings ratings = incomplete(c.input.at("coder_by_unit"));
  EXPECT_TRUE(matches(krippendorffAlpha(ratings, AlphaMetric::kNominal)->alpha,
                      c.expected.at("nominal").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(krippendorffAlpha(ratings, AlphaMetric::kOrdinal)->alpha,
                      c.expected.at("ordinal").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(krippendorffAlpha(ratings, AlphaMetric::kInterval)->alpha,
                      c.expected.at("interval").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(krippendorffAlpha(ratings, AlphaMetric::kRatio)->alpha,
                      c.expected.at("ratio").get<double>(), c.tolerance));
}

TEST(KrippendorffAlpha, IsUndefinedWhenNothingVaries) {
  EXPECT_THAT(krippendorffAlpha({{3.0, 3.0}, {3.0, 3.0}}, AlphaMetric::kInterval).reason().str(),
              ::testing::HasSubstr("same"));
  EXPECT_FALSE(krippendorffAlpha({{3.0, std::nullopt}, {std::nullopt, 2.0}}, AlphaMetric::kInterval));
}

TEST(KrippendorffInterval, ContainsThePointEstimateAndIsReproducible) {
  const IncompleteRatings ratings =
      incomplete(referenceCase("agreement", "kripp_textbook").input.at("coder_by_unit_null_missing"));
  const double alpha = krippendorffAlpha(ratings, AlphaMetric::kInterval)->alpha;
  const Outcome<AlphaBootstrap> one = krippendorffInterval(ratings, AlphaMetric::kInterval, 5, 999);
  const Outcome<AlphaBootstrap> two = krippendorffInterval(ratings, AlphaMetric::kInterval, 5, 999);
  EXPECT_LT(one->interval.lower, alpha);
  EXPECT_GT(one->interval.upper, alpha);
  EXPECT_EQ(one->interval.lower, two->interval.lower);
}

void expectKappa(const KappaResult& got, const nlohmann::json& expected, double tolerance) {
  EXPECT_TRUE(matches(got.kappa, expected.at("kappa").get<double>(), tolerance));
  EXPECT_TRUE(matches(got.observed, expected.at("po").get<double>(), tolerance));
  EXPECT_TRUE(matches(got.expected, expected.at("pe").get<double>(), tolerance));
  EXPECT_TRUE(matches(got.error, expected.at("se").get<double>(), tolerance));
  EXPECT_TRUE(matches(got.errorUnderNull, expected.at("se0").get<double>(), tolerance));
  EXPECT_TRUE(matches(got.z.value(), expected.at("z").get<double>(), tolerance));
}

TEST(CohenKappa, AgreesWithTheWorkedTableForAllWeights) {
  const ReferenceCase c = referenceCase("agreement", "kappa_cohen_1968");
  const NumberTable table = tableOf(c.input.at("table"));
  expectKappa(*cohenKappa(table, KappaWeights::kUnweighted), c.expected.at("unweighted"), c.tolerance);
  expectKappa(*cohenKappa(table, KappaWeights::kLinear), c.expected.at("linear"), c.tolerance);
  expectKappa(*cohenKappa(table, KappaWeights::kQuadratic), c.expected.at("quadratic"), c.tolerance);
  expectKappa(*cohenKappa(table, tableOf(c.input.at("custom_disagreement"))), c.expected.at("custom"),
              c.tolerance);
}

TEST(CohenKappa, AgreesOnTwoRatersOfTheAnxietyData) {
  const ReferenceCase c = referenceCase("agreement", "kappa_anxiety_r1_r2");
  NumberTable table(6, 6);
  for (const nlohmann::json& pair : c.input.at("ratings")) {
    table.at(pair[0].get<std::size_t>() - 1, pair[1].get<std::size_t>() - 1) += 1.0;
  }
  expectKappa(*cohenKappa(table, KappaWeights::kUnweighted), c.expected.at("un"), c.tolerance);
  expectKappa(*cohenKappa(table, KappaWeights::kLinear), c.expected.at("eq"), c.tolerance);
  expectKappa(*cohenKappa(table, KappaWeights::kQuadratic), c.expected.at("sq"), c.tolerance);
}

TEST(CohenKappa, WithQuadraticWeightsNeedsNoTable) {
  const std::vector<double> first{3, 4, 4, 2, 5, 1, 3};
  const std::vector<double> second{3, 5, 4, 1, 4, 1, 2};
  NumberTable table(5, 5);
  for (std::size_t i = 0; i < first.size(); ++i) {
    table.at(static_cast<std::size_t>(first[i]) - 1, static_cast<std::size_t>(second[i]) - 1) += 1.0;
  }
  EXPECT_NEAR(*quadraticKappa(first, second), cohenKappa(table, KappaWeights::kQuadratic)->kappa, 1e-15);
  EXPECT_FALSE(quadraticKappa(std::vector<double>{3.0}, std::vector<double>{4.0}));  // 0 by construction
  EXPECT_FALSE(quadraticKappa(std::vector<double>{3.0, 3.0}, std::vector<double>{3.0, 3.0}));
}

TEST(CohenKappa, IsUndefinedWhenOnlyOneCategoryIsUsed) {
  EXPECT_FALSE(cohenKappa(NumberTable({{7, 0}, {0, 0}}), KappaWeights::kUnweighted));
  EXPECT_FALSE(cohenKappa(NumberTable({{0, 0}, {0, 0}}), KappaWeights::kUnweighted));
}

TEST(FleissKappa, AgreesWithThePublishedDiagnosesAndTheSecondExample) {
  const ReferenceCase c = referenceCase("agreement", "fleiss_kappa_1971");
  const Outcome<FleissResult> got = fleissKappa(tableOf(c.input.at("counts_subject_by_category")));
  EXPECT_TRUE(matches(got->kappa, c.expected.at("kappa").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->observed, c.expected.at("Pbar").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->expected, c.expected.at("Pe").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->errorUnderNull, c.expected.at("se0").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->z, c.expected.at("z").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->errorByCategory, c.expected.at("se_j").get<double>(), c.tolerance));
  for (std::size_t j = 0; j < 5; ++j) {
    EXPECT_TRUE(matches(got->byCategory[j].value(), c.expected.at("kappa_j")[j].get<double>(), c.tolerance));
  }
  const ReferenceCase second = referenceCase("agreement", "fleiss_kappa_10x14");
  const Outcome<FleissResult> other = fleissKappa(tableOf(second.input.at("counts_subject_by_category")));
  EXPECT_TRUE(matches(other->kappa, second.expected.at("kappa").get<double>(), second.tolerance));
  EXPECT_TRUE(matches(other->errorUnderNull, second.expected.at("se0").get<double>(), second.tolerance));
  EXPECT_TRUE(matches(other->z, second.expected.at("z").get<double>(), second.tolerance));
  EXPECT_THROW((void)fleissKappa(NumberTable({{2, 1}, {1, 1}})), Error);
}

TEST(KendallW, AgreesOnTheAnxietyRatingsWithTieCorrection) {
  const ReferenceCase c = referenceCase("agreement", "kendall_w_anxiety");
  const Outcome<KendallResult> got = kendallW(tableOf(c.input.at("ratings_subject_by_rater")));
  EXPECT_TRUE(matches(got->s, c.expected.at("S").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->tieTerm, c.expected.at("T").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->w, c.expected.at("W").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->chiSquared, c.expected.at("chi2").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->p, c.expected.at("p").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->wUncorrected, c.expected.at("W_uncorrected").get<double>(), c.tolerance));
  EXPECT_FALSE(kendallW(NumberTable({{4, 4}, {4, 4}, {4, 4}})));
}

TEST(CronbachAlpha, AgreesOnTheAttitudeDataAndWithTheConsistencyCorrelation) {
  const ReferenceCase c = referenceCase("agreement", "cronbach_attitude");
  const Outcome<CronbachResult> got = cronbachAlpha(tableOf(c.input.at("items_30x7")));
  EXPECT_TRUE(matches(got->alpha, c.expected.at("alpha").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->interval.lower, c.expected.at("ci")[0].get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->interval.upper, c.expected.at("ci")[1].get<double>(), c.tolerance));
  EXPECT_TRUE(
      matches(got->standardized.value(), c.expected.at("standardized_alpha").get<double>(), c.tolerance));
  for (std::size_t j = 0; j < 7; ++j) {
    EXPECT_TRUE(
        matches(got->alphaWithout[j].value(), c.expected.at("if_deleted")[j].get<double>(), c.tolerance));
  }
  const ReferenceCase same = referenceCase("agreement", "cronbach_shrout_fleiss");
  const NumberTable ratings =
      tableOf(referenceCase("agreement", "icc_shrout_fleiss_1979").input.at("ratings_target_by_judge"));
  const Outcome<CronbachResult> asScale = cronbachAlpha(ratings);
  EXPECT_TRUE(matches(asScale->alpha, same.expected.at("alpha").get<double>(), same.tolerance));
  EXPECT_TRUE(matches(asScale->interval.lower, same.expected.at("ci")[0].get<double>(), same.tolerance));
  EXPECT_TRUE(matches(asScale->interval.upper, same.expected.at("ci")[1].get<double>(), same.tolerance));
  EXPECT_NEAR(asScale->alpha, intraclassCorrelation(ratings)->consistencyMean.estimate, 1e-12);
}

TEST(BlandAltman, AgreesWithTheFirstReadingsOfBothMeters) {
  const ReferenceCase c = referenceCase("agreement", "bland_altman_1986");
  const std::vector<double> wright = numbers(c.input.at("wright"));
  const std::vector<double> mini = numbers(c.input.at("mini"));
  const Outcome<BlandAltmanResult> got = blandAltman(wright, mini);
  const auto expectInterval = [&](const Interval& interval, const char* name) {
    EXPECT_TRUE(matches(interval.lower, c.expected.at(name)[0].get<double>(), c.tolerance)) << name;
    EXPECT_TRUE(matches(interval.upper, c.expected.at(name)[1].get<double>(), c.tolerance)) << name;
  };
  EXPECT_TRUE(matches(got->meanDifference, c.expected.at("mean").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->deviation, c.expected.at("sd").get<double>(), c.tolerance));
  expectInterval(got->limits, "loa_196");
  expectInterval(got->meanInterval, "mean_ci");
  expectInterval(got->lowerLimitInterval, "loa_lower_ci");
  expectInterval(blandAltman(wright, mini, 2.0)->limits, "loa_2sd_published");
  EXPECT_TRUE(matches(got->limitError, c.expected.at("loa_se_approx").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->limitErrorExact, c.expected.at("loa_se_exact_form").get<double>(), c.tolerance));
}

TEST(BlandAltmanAgainstPanel, ExcludesTheRaterFromThePanel) {
  // Rater 1 gives 1 more than the other two, who agree: the difference is 1, not 2/3 as against the full
  // panel.
  const auto got = blandAltmanAgainstPanel(NumberTable({{6, 5, 5}, {8, 7, 7}, {4, 3, 3}}));
  ASSERT_EQ(got.size(), 3U);
  EXPECT_DOUBLE_EQ(got[0]->meanDifference, 1.0);
  EXPECT_DOUBLE_EQ(got[1]->meanDifference, -0.5);
}

// Mean square of trainees within both groups, of raters and rest over both, by hand in R; interval after
// McGraw and Wong with their degrees of freedom.
TEST(Generalizability, WithinGroupsTheDifferenceBetweenThemDoesNotCount) {
  const NumberTable first({{5, 6, 5}, {7, 7, 8}, {4, 6, 5}, {8, 8, 9}});
  const std::vector<std::vector<double>> second{{6, 7, 7}, {9, 9, 8}, {5, 7, 6}};
  const GStudy found = gStudyPRWithin({first, NumberTable(second)}).value();
  EXPECT_NEAR(found.at("p").variance, 2.174074074074074, 1e-12);
  EXPECT_NEAR(found.at("r").variance, 0.1349206349206351, 1e-12);
  EXPECT_NEAR(found.at("pr").variance, 0.3888888888888889, 1e-12);
  EXPECT_NEAR(dStudyPR(found, 5.0)->dependability, 0.9540283259809612, 1e-12);
  const Interval one = dependabilityInterval(found, 1.0).value();
  EXPECT_NEAR(one.lower, 0.4500957881277023, 1e-9);
  EXPECT_NEAR(one.upper, 0.9663701925455175, 1e-9);
  const Interval five = dependabilityInterval(found, 5.0).value();
  EXPECT_NEAR(five.lower, 0.8036325095802493, 1e-9);
  EXPECT_NEAR(five.upper, 0.9930880813134477, 1e-9);
  // A whole group two points better changes nothing; somebody alone in a group neither.
  std::vector<std::vector<double>> raised = second;
  for (std::vector<double>& row : raised) {
    for (double& mark : row) {
      mark += 2.0;
    }
  }
  const GStudy shifted = gStudyPRWithin({first, NumberTable(raised), NumberTable({{1, 2, 3}})}).value();
  EXPECT_NEAR(shifted.at("p").variance, found.at("p").variance, 1e-12);
  EXPECT_EQ(shifted.personsPerRater, 7.0);
}

}  // namespace
}  // namespace torsio
