// SPDX-License-Identifier: GPL-3.0-or-later

#include <cmath>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/statistics/ancova.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/multiplicity.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/shapiro_wilk.h"
#include "tests/assessment/reference_case.h"

namespace torsio {

namespace {

using test::Expect;
using test::expectHedges;
using test::expectMannWhitney;
using test::expectTTest;
using test::matches;
using test::numbers;
using test::PlantGrowth;
using test::ReferenceCase;
using test::referenceCase;
using test::Sleep;

TEST(MeanTests, OfNumbersWhoseSquaresOverflowAreUndefinedWithAReason) {
  const std::vector<double> usual{1.0, 2.0, 4.0};
  const std::vector<double> huge{1e200, -1e200, 3e199};
  const std::vector<double> close{0.0, 5e-324, 1e-300};

  EXPECT_EQ(welchT(usual, huge).reason(), Text::tr("the values are too large to be squared"));
  EXPECT_EQ(pairedT(huge, usual).reason(), Text::tr("the values are too large to be squared"));
  EXPECT_EQ(oneWayAnova({usual, huge}).reason(), Text::tr("the values are too large to be squared"));
  EXPECT_EQ(shapiroWilk(close).reason(), Text::tr("the values lie too close together to be squared"));
  EXPECT_TRUE(welchT(usual, std::vector<double>{1e70, -1e70, 3e69}));
  EXPECT_TRUE(beyondArithmetic(std::vector<double>{1.0, std::nan(""), 2.0}));  // a mean that overflowed
}

TEST(WelchT, AgreesOnTheSleepData) {
  const Sleep sleep;
  expectTTest(*welchT(sleep.x, sleep.y), {sleep.welch.expected, sleep.welch.tolerance});
  // Student's test of the same data, R's sleep.
  EXPECT_NEAR(studentT(sleep.x, sleep.y)->p, 0.0791867142, 1e-10);
}

TEST(PairedT, AgreesOnTheSleepData) {
  const Sleep sleep;
  const ReferenceCase c = referenceCase("groups", "paired_sleep");
  const Outcome<TTest> got = pairedT(sleep.x, sleep.y);
  const Expect expect{c.expected, c.tolerance};
  expect.value("t", got->t);
  expect.value("df", got->df);
  expect.value("p", got->p);
  expect.value("mean", got->difference);
  expect.value("sd", got->error * std::sqrt(10.0));
}

TEST(HedgesG, AgreesOnTheSleepDataWithNoncentralIntervals) {
  const Sleep sleep;
  const ReferenceCase c = referenceCase("groups", "hedges_sleep");
  const Outcome<HedgesG> got = hedgesG(sleep.x, sleep.y);
  expectHedges(*got, {c.expected, c.tolerance});
  // Swapping the groups mirrors all values.
  const Outcome<HedgesG> mirrored = hedgesG(sleep.y, sleep.x);
  EXPECT_NEAR(mirrored->interval.lower, -got->interval.upper, 1e-10);
}

TEST(TTests, AreUndefinedWithoutVariationOrValues) {
  const std::vector<double> constant = {2, 2, 2};
  const std::vector<double> one = {1};
  EXPECT_FALSE(welchT(constant, constant));
  EXPECT_FALSE(welchT(one, constant));
  EXPECT_FALSE(pairedT(constant, constant));
  EXPECT_FALSE(hedgesG(constant, constant));
  EXPECT_THAT(mannWhitney(constant, constant).reason().str(), ::testing::HasSubstr("same"));
  EXPECT_FALSE(oneWayAnova({{1, 1}, {2, 2}}));
  EXPECT_FALSE(welchAnova({{1, 1}, {2, 3}}));
  EXPECT_FALSE(kruskalWallis({{1, 1}, {1, 1}}));
}

// R: t.test(x, y) stops with "data are essentially constant".
TEST(MeanTests, OfGroupsThatVaryOnlyByRoundingAreUndefined) {
  const std::vector<double> ones = {1.0, 1.0, 1.0, 1.0000000000000002};
  const std::vector<double> millions = {1e6, 1e6, 1e6, 1e6 + 1e-10};
  const std::vector<double> real = {1.0, 1.0, 1.0, 1.000000000001};  // one decimal beyond rounding
  EXPECT_EQ(welchT(ones, millions).reason(), Text::tr("the values do not vary"));
  EXPECT_EQ(studentT(ones, millions).reason(), Text::tr("the values do not vary"));
  EXPECT_FALSE(hedgesG(ones, millions));
  EXPECT_FALSE(oneWayAnova({ones, millions}));
  EXPECT_FALSE(tukeyPairs({ones, millions}));
  EXPECT_FALSE(gamesHowellPairs({ones, millions}));
  EXPECT_FALSE(brownForsythe({ones, millions}));
  EXPECT_FALSE(shapiroWilk(ones));
  EXPECT_EQ(welchAnova({real, ones}).reason(), Text::tr("a group does not vary"));
  EXPECT_EQ(bartlett({real, ones}).reason(), Text::tr("a group does not vary"));
  EXPECT_TRUE(welchT(real, ones));
  EXPECT_GT(*sampleDeviation(ones), 0.0);  // the description keeps it
}

TEST(OneWayAnova, AgreesOnThePlantData) {
  const PlantGrowth plants;
  const nlohmann::json& e = plants.reference.expected;
  const Expect expect{e, plants.reference.tolerance};
  const Outcome<OneWayAnova> got = oneWayAnova(plants.groups);
  expect.value("SSB", got->ssBetween);
  expect.value("SSW", got->ssWithin);
  expect.value("F", got->f);
  expect.value("p", got->p);
  expect.value("eta2", got->etaSquared);
  expect.value("omega2", got->omegaSquared);
  expect.value("epsilon2_anova", got->epsilonSquared);
  const Outcome<FTest> welch = welchAnova(plants.groups);
  const Expect expectWelch{e.at("welch"), plants.reference.tolerance};
  expectWelch.value("F", welch->f);
  expectWelch.value("df2", welch->df2);
  expectWelch.value("p", welch->p);
  const Expect spread{e.at("brown_forsythe"), plants.reference.tolerance};
  spread.value("F", brownForsythe(plants.groups)->f);
  spread.value("p", brownForsythe(plants.groups)->p);
  const Expect variances{e.at("bartlett"), plants.reference.tolerance};
  variances.value("K2", bartlett(plants.groups)->statistic);
  variances.value("p", bartlett(plants.groups)->p);
}

TEST(ShapiroWilk, AgreesOnTheResidualsOfThePlantData) {
  const PlantGrowth plants;
  std::vector<double> residuals;
  for (const std::vector<double>& group : plants.groups) {
    for (const double x : group) {
      residuals.push_back(x - meanOf(group));
    }
  }
  const Outcome<NormalityTest> got = shapiroWilk(residuals);
  const Expect expect{plants.reference.expected.at("shapiro_residuals"), plants.reference.tolerance};
  expect.value("W", got->w);
  expect.value("p", got->p);
}

TEST(PairComparisons, AgreeOnThePlantDataForEveryTest) {
  const PlantGrowth plants;
  const Outcome<std::vector<PairComparison>> tukey = tukeyPairs(plants.groups);
  const Outcome<std::vector<PairComparison>> howell = gamesHowellPairs(plants.groups);
  const nlohmann::json& hsd =
      plants.reference.expected.at("tukey_hsd_rows_trt1-ctrl_trt2-ctrl_trt2-trt1_cols_diff_lwr_upr_p");
  for (std::size_t i = 0; i < 3; ++i) {
    const nlohmann::json& e = plants.reference.expected.at("pairs").at(plants.names[i]);
    const std::vector<double>& x = plants.groups[plants.first[i]];
    const std::vector<double>& y = plants.groups[plants.second[i]];
    const double tolerance = plants.reference.tolerance;
    expectTTest(*welchT(x, y), {e.at("welch"), tolerance});
    expectHedges(*hedgesG(x, y), {e.at("hedges"), tolerance});
    expectMannWhitney(*mannWhitney(x, y), {e.at("mann_whitney"), tolerance});
    const Expect expect{e, tolerance};
    expect.value("tukey_q", (*tukey)[i].q);
    expect.value("tukey_p", (*tukey)[i].p);
    expect.value("games_howell_p", (*howell)[i].p);
    EXPECT_TRUE(matches((*tukey)[i].difference, hsd[i][0].get<double>(), tolerance));
    // The printed bounds use a quantile that R computes to about 1e-4 of its last step.
    EXPECT_NEAR((*tukey)[i].interval.lower, hsd[i][1].get<double>(), 2e-6);
    EXPECT_NEAR((*tukey)[i].interval.upper, hsd[i][2].get<double>(), 2e-6);
    const Outcome<PermutationTest> permutation = permutationTest(*asWholeNumbers(x), *asWholeNumbers(y));
    EXPECT_EQ(permutation->count, e.at("permutation_mean").at("count").get<std::int64_t>());
    EXPECT_EQ(permutation->total, e.at("permutation_mean").at("total").get<std::int64_t>());
  }
}

TEST(AdjustedP, AgreesForAllMethods) {
  const ReferenceCase c = referenceCase("groups", "p_adjust");
  const std::vector<double> p = numbers(c.input.at("p"));
  const auto expectAll = [&](const std::vector<double>& got, const char* name) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_TRUE(matches(got[i], c.expected.at(name)[i].get<double>(), c.tolerance)) << name;
    }
  };
  expectAll(adjustHolm(p), "holm");
  expectAll(adjustBenjaminiHochberg(p), "BH");
  expectAll(adjustBonferroni(p), "bonferroni");
  expectAll(adjustHochberg(p), "hochberg");
}

TEST(GroupTests, LeaveEmptyGroupsOutAndKeepTheNumbersOfTheOthers) {
  const Groups two = {{4.1, 5.2, 6.3, 5.5}, {6.0, 7.1, 7.9, 6.4}};
  const Groups four = {{}, two[0], {}, two[1]};
  EXPECT_EQ(oneWayAnova(four)->f, oneWayAnova(two)->f);
  EXPECT_EQ(welchAnova(four)->f, welchAnova(two)->f);
  EXPECT_EQ(brownForsythe(four)->f, brownForsythe(two)->f);
  EXPECT_EQ(bartlett(four)->statistic, bartlett(two)->statistic);
  EXPECT_EQ(kruskalWallis(four)->h, kruskalWallis(two)->h);
  EXPECT_EQ(kruskalWallis(four)->pExact, kruskalWallis(two)->pExact);
  EXPECT_EQ(tukeyPairs(four)->at(0).p, tukeyPairs(two)->at(0).p);
  EXPECT_EQ(gamesHowellPairs(four)->at(0).p, gamesHowellPairs(two)->at(0).p);
  const Groups before = {{}, {3.0, 4.5, 4.0, 5.0}, {}, {5.0, 5.5, 6.5, 4.9}};
  const Outcome<Ancova> whole = ancova(before, four);
  const Outcome<Ancova> alone = ancova({before[1], before[3]}, two);
  ASSERT_TRUE(whole && alone);
  EXPECT_EQ(whole->groups, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(whole->pairs.at(0).p, alone->pairs.at(0).p);
  EXPECT_EQ(whole->residuals.at(3), alone->residuals.at(1));
  EXPECT_TRUE(whole->residuals.at(0).empty());
  for (const auto& [first, second] :
       {std::pair{kruskalWallis(four)->pairs.at(0).first, kruskalWallis(four)->pairs.at(0).second},
        std::pair{tukeyPairs(four)->at(0).first, tukeyPairs(four)->at(0).second},
        std::pair{whole->pairs.at(0).first, whole->pairs.at(0).second}}) {
    EXPECT_EQ(first, 1U);
    EXPECT_EQ(second, 3U);
  }
  EXPECT_FALSE(oneWayAnova({{}, two[0]}));
  EXPECT_FALSE(kruskalWallis({{}, two[0]}));
  EXPECT_FALSE(ancova({{}, before[1]}, {{}, two[0]}));
}

TEST(OneWayAnova, AgreesWithTheCertifiedValuesOfSiRstv) {
  const ReferenceCase c = referenceCase("groups", "nist_sirstv_anova");
  const Outcome<OneWayAnova> got = oneWayAnova(c.input.at("groups").get<Groups>());
  const Expect expect{c.expected, c.tolerance};
  expect.value("SSB", got->ssBetween);
  expect.value("SSW", got->ssWithin);
  expect.value("MSB", got->msBetween);
  expect.value("MSW", got->msWithin);
  expect.value("F", got->f);
  expect.value("p", got->p);
}

TEST(SampleDeviation, IsRobustToALargeOffset) {
  const ReferenceCase c = referenceCase("groups", "nist_numacc4");
  std::vector<double> values = {10000000.2};
  for (int i = 0; i < 500; ++i) {
    values.push_back(10000000.1);
    values.push_back(10000000.3);
  }
  EXPECT_TRUE(matches(meanOf(values), c.expected.at("mean").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(*sampleDeviation(values), c.expected.at("sd").get<double>(), c.tolerance));
}

}  // namespace

namespace {

using test::Expect;
using test::expectHedges;
using test::expectKruskal;
using test::expectMannWhitney;
using test::matches;
using test::numbers;
using test::PlantGrowth;
using test::ReferenceCase;
using test::referenceCase;
using test::Sleep;
using test::Study;

TEST(MannWhitney, CountsTheExactConditionalDistributionWithTies) {
  const Sleep sleep;
  const ReferenceCase c = referenceCase("groups", "mann_whitney_sleep_ties");
  expectMannWhitney(*mannWhitney(sleep.x, sleep.y), {c.expected, c.tolerance});
}

TEST(MannWhitney, AgreesWithHollanderAndWolfe) {
  const ReferenceCase c = referenceCase("groups", "mann_whitney_hollander_wolfe");
  const Expect expect{c.expected, c.tolerance};
  const Outcome<MannWhitney> got = mannWhitney(numbers(c.input.at("x")), numbers(c.input.at("y")));
  expectMannWhitney(*got, expect);
  expect.interval("hl_ci95", *got->hodgesLehmannInterval);
}

TEST(SignedRank, AgreesWithHollanderAndWolfe) {
  const ReferenceCase c = referenceCase("groups", "signed_rank_hollander_wolfe");
  const std::vector<double> x = numbers(c.input.at("x"));
  const std::vector<double> y = numbers(c.input.at("y"));
  std::vector<double> differences;
  // Integer thousandths, so that ties are exact.
  for (std::size_t i = 0; i < x.size(); ++i) {
    differences.push_back(std::round(1000.0 * x[i]) - std::round(1000.0 * y[i]));
  }
  const Outcome<SignedRank> got = signedRank(differences);
  const Expect expect{c.expected, c.tolerance};
  expect.value("V", got->v);
  expect.value("p_greater", got->pGreater);
  expect.value("p_two", got->pTwoSided);
  expect.value("hodges_lehmann", got->hodgesLehmann / 1000.0);
}

TEST(KruskalWallis, AgreesWithHollanderAndWolfeIncludingTheExactP) {
  const ReferenceCase c = referenceCase("groups", "kruskal_hollander_wolfe");
  const Outcome<KruskalWallis> got = kruskalWallis(c.input.at("groups").get<Groups>());
  const Expect expect{c.expected, c.tolerance};
  expect.value("H", got->h);
  expect.value("H_uncorrected", got->hUncorrected);
  expect.value("p", got->p);
  expect.value("epsilon2", got->epsilonSquared);
  expect.value("eta2_H", got->etaSquaredH);
  EXPECT_EQ(got->exactCount, c.expected.at("exact_count").get<std::int64_t>());
  EXPECT_EQ(got->exactTotal, c.expected.at("exact_total").get<std::int64_t>());
  expect.value("p_exact", *got->pExact);
}

TEST(KruskalWallis, AgreesOnThePlantDataWithDunnAndHolm) {
  const PlantGrowth plants;
  const nlohmann::json& e = plants.reference.expected;
  expectKruskal(*kruskalWallis(plants.groups), e.at("kw"), e.at("dunn"), plants.reference.tolerance);
}

TEST(Friedman, AgreesWithHollanderAndWolfe) {
  const ReferenceCase c = referenceCase("groups", "friedman_hollander_wolfe");
  const Outcome<Friedman> got =
      friedman(NumberTable(c.input.at("blocks_by_treatment").get<std::vector<std::vector<double>>>()));
  const Expect expect{c.expected, c.tolerance};
  EXPECT_EQ(got->rankSums, numbers(c.expected.at("rank_sums")));
  expect.value("chi2", got->chiSquared);
  expect.value("p", got->p);
  expect.value("kendall_W", got->kendallW);
  expect.value("F_iman_davenport", *got->imanDavenport);
  expect.value("p_F", *got->pImanDavenport);
}

TEST(Friedman, GivesTheOrderOfTheThreeModelsInExampleThree) {
  const nlohmann::json example = referenceCase("evaluation", "eq25_ex3_20_10_10").expected;
  NumberTable values(40, 3);
  std::size_t model = 0;
  for (const char* name : {"PM", "FEM", "MSM"}) {
    std::size_t rater = 0;
    for (const char* id : {"A", "B", "C"}) {
      for (const double x : numbers(example.at("models").at(name).at("rater_composites").at(id))) {
        values.at(rater++, model) = x;
      }
    }
    ++model;
  }
  const Outcome<Friedman> got = friedman(values);
  const nlohmann::json& expected = example.at("friedman_over_models_on_rater_composites");
  EXPECT_DOUBLE_EQ(got->chiSquared, expected.at("chi2").get<double>());
  EXPECT_TRUE(matches(got->p, expected.at("p").get<double>(), 1e-9));
  EXPECT_DOUBLE_EQ(got->kendallW, 1.0);
  EXPECT_FALSE(got->imanDavenport.has_value());
}

TEST(PairedPermutationTest, AgreesOnDarwinsMaize) {
  const ReferenceCase c = referenceCase("groups", "permutation_darwin");
  const Outcome<PermutationTest> got =
      pairedPermutationTest(c.input.at("d").get<std::vector<std::int64_t>>());
  EXPECT_EQ(got->count, c.expected.at("count_two").get<std::int64_t>());
  EXPECT_EQ(got->total, c.expected.at("total").get<std::int64_t>());
  EXPECT_TRUE(matches(got->p, c.expected.at("p_two").get<double>(), c.tolerance));
  const std::vector<double> d = numbers(c.input.at("d"));
  const Outcome<TTest> t = pairedT(d, std::vector<double>(d.size(), 0.0));
  EXPECT_TRUE(matches(t->t, c.expected.at("t").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(t->p, c.expected.at("p_t").get<double>(), 1e-11));  // printed to 15 digits
}

TEST(GainScores, AreRankedOnExactDecimals) {
  const Study study;
  const nlohmann::json& e = study.reference.expected.at("gain_scores");
  const Groups gains = study.gainsInTenths();
  expectKruskal(*kruskalWallis(gains), e.at("kw"), e.at("dunn"), study.reference.tolerance);
  const Outcome<FTest> welch = welchAnova(gains);
  const Expect expectWelch{e.at("welch"), study.reference.tolerance};
  expectWelch.value("F", welch->f);
  expectWelch.value("df2", welch->df2);
  expectWelch.value("p", welch->p);
  const char* names[] = {"1-2", "1-3", "2-3"};
  const std::size_t first[] = {0, 0, 1};
  const std::size_t second[] = {1, 2, 2};
  for (std::size_t i = 0; i < 3; ++i) {
    const nlohmann::json& pair = e.at("pairs").at(names[i]);
    expectHedges(*hedgesG(gains[first[i]], gains[second[i]]), {pair.at("hedges"), study.reference.tolerance});
    expectMannWhitney(*mannWhitney(gains[first[i]], gains[second[i]]),
                      {pair.at("mw"), study.reference.tolerance});
  }
  // The pitfall itself: differences of doubles split ties and change H.
  Groups noisy;
  for (std::size_t g = 0; g < 3; ++g) {
    noisy.emplace_back();
    for (const std::vector<double>& trainee : study.scores[g]) {
      noisy.back().push_back(trainee[2] - trainee[0]);
    }
  }
  EXPECT_NEAR(kruskalWallis(noisy)->h, 21.297724, 1e-5);
}

// R: m <- sum(w * means); p <- w^2 * var / n; v <- sum(p); df <- v^2 / sum(p^2 / (n - 1)).
TEST(StratifiedMean, WeighsTheClassesAndTheirErrors) {
  const Groups strata{{8.1, 7.4, 8.8, 9.0}, {6.9, 7.7, 8.2}, {1.0}};
  const double weights[] = {3.0, 7.0, 0.0};
  const TTest found = stratifiedMean(strata, weights).value();
  EXPECT_NEAR(found.difference, 7.817499999999999, 1e-12);
  EXPECT_NEAR(found.error, 0.286600040707138, 1e-12);
  EXPECT_NEAR(found.df, 2.684148215222205, 1e-12);
  EXPECT_NEAR(found.p, 0.000233275071391699, 1e-12);
  EXPECT_NEAR(found.interval.lower, 6.841581608023162, 1e-9);
  EXPECT_NEAR(found.interval.upper, 8.793418391976836, 1e-9);
  const double other[] = {3.0, 7.0, 1.0};
  EXPECT_FALSE(stratifiedMean(strata, other)) << "a class of one";
  EXPECT_FALSE(stratifiedMean({{2.0, 2.0}, {3.0, 3.0}}, std::vector<double>{1.0, 1.0})) << "no spread";
}

}  // namespace

}  // namespace torsio
