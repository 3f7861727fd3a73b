// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/scoring/training_scores.h"
#include "assessment/statistics/ancova.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/mixed_anova.h"
#include "assessment/statistics/multiplicity.h"
#include "assessment/statistics/rank_tests.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using test::matches;
using test::numbers;
using test::ReferenceCase;
using test::referenceCase;

struct Expect {
  const nlohmann::json& expected;
  double tolerance;

  void value(const char* name, double got) const {
    EXPECT_TRUE(matches(got, expected.at(name).get<double>(), tolerance)) << name;
  }
  void interval(const char* name, const Interval& got) const {
    EXPECT_TRUE(matches(got.lower, expected.at(name)[0].get<double>(), tolerance)) << name;
    EXPECT_TRUE(matches(got.upper, expected.at(name)[1].get<double>(), tolerance)) << name;
  }
};

void expectTTest(const TTest& got, const Expect& expect) {
  expect.value("diff", got.difference);
  expect.value("se", got.error);
  expect.value("t", got.t);
  expect.value("df", got.df);
  expect.value("p", got.p);
  expect.interval("ci", got.interval);
}

void expectHedges(const HedgesG& got, const Expect& expect) {
  expect.value("d", got.d);
  expect.value("J_exact", got.correction);
  expect.value("g", got.g);
  expect.interval("ncp_ci", got.noncentrality);
  expect.interval("d_ci_nct", got.dInterval);
  expect.interval("g_ci_nct", got.interval);
  expect.value("se_g", got.error);
  expect.interval("g_ci_normal", got.normalInterval);
}

void expectMannWhitney(const MannWhitney& got, const Expect& expect, double unit = 1.0) {
  expect.value("U", got.u);
  expect.value("A12", got.superiority);
  EXPECT_NEAR(got.cliffDelta, expect.expected.at("cliff_delta").get<double>(), 1e-12);
  EXPECT_EQ(got.ties, expect.expected.at("ties").get<bool>());
  expect.value("z_cc", got.zCorrected);
  expect.value("p_norm_cc", got.pCorrected);
  expect.value("z", got.z);
  expect.value("p_norm", got.pNormal);
  EXPECT_EQ(got.countTwoSided, expect.expected.at("exact_count_two").get<std::int64_t>());
  EXPECT_EQ(got.arrangements, expect.expected.at("exact_total").get<std::int64_t>());
  EXPECT_EQ(got.countGreater, expect.expected.at("exact_count_greater").get<std::int64_t>());
  expect.value("p_exact_two", *got.pExact);
  expect.value("p_exact_greater", *got.pGreater);
  expect.value("hodges_lehmann", got.hodgesLehmann * unit);
}

struct Sleep {
  ReferenceCase welch = referenceCase("groups", "welch_sleep");
  std::vector<double> x = numbers(welch.input.at("x"));
  std::vector<double> y = numbers(welch.input.at("y"));
};

TEST(MeanTests, OfNumbersWhoseSquaresAreNoneAreUndefinedAndSayWhy) {
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
  // Student's test of the same data, R sleep.
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
  // Swapping the groups mirrors everything.
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
  // Whole thousandths, so that ties are ties.
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

struct PlantGrowth {
  ReferenceCase reference = referenceCase("groups", "plantgrowth_three_groups_of_ten");
  Groups groups = {numbers(reference.input.at("ctrl")), numbers(reference.input.at("trt1")),
                   numbers(reference.input.at("trt2"))};
  const char* names[3] = {"ctrl-trt1", "ctrl-trt2", "trt1-trt2"};
  std::size_t first[3] = {0, 0, 1};
  std::size_t second[3] = {1, 2, 2};
};

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

void expectKruskal(const KruskalWallis& got, const nlohmann::json& kw, const nlohmann::json& dunn,
                   double tolerance) {
  const Expect expect{kw, tolerance};
  expect.value("H_uncorrected", got.hUncorrected);
  expect.value("C", got.tieCorrection);
  expect.value("H", got.h);
  expect.value("p", got.p);
  expect.value("epsilon2", got.epsilonSquared);
  expect.value("eta2_H", got.etaSquaredH);
  expect.value("T", got.tieTerm);
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_TRUE(matches(got.meanRanks[g], kw.at("mean_ranks")[g].get<double>(), tolerance));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Expect pair{dunn[i], tolerance};
    pair.value("diff", got.pairs[i].difference);
    pair.value("se", got.pairs[i].error);
    pair.value("z", got.pairs[i].z);
    pair.value("p", got.pairs[i].p);
    pair.value("p_holm", got.pairs[i].pHolm);
  }
}

TEST(KruskalWallis, AgreesOnThePlantDataWithDunnAndHolm) {
  const PlantGrowth plants;
  const nlohmann::json& e = plants.reference.expected;
  expectKruskal(*kruskalWallis(plants.groups), e.at("kw"), e.at("dunn"), plants.reference.tolerance);
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
    // The printed bounds come from a quantile that R finds to about 1e-4 of its last step.
    EXPECT_NEAR((*tukey)[i].interval.lower, hsd[i][1].get<double>(), 2e-6);
    EXPECT_NEAR((*tukey)[i].interval.upper, hsd[i][2].get<double>(), 2e-6);
    const Outcome<PermutationTest> permutation = permutationTest(*asWholeNumbers(x), *asWholeNumbers(y));
    EXPECT_EQ(permutation->count, e.at("permutation_mean").at("count").get<std::int64_t>());
    EXPECT_EQ(permutation->total, e.at("permutation_mean").at("total").get<std::int64_t>());
  }
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

void expectSphericity(const Sphericity& got, const nlohmann::json& e, double tolerance) {
  const Expect expect{e, tolerance};
  expect.value("HF_corrected_lecoutre", got.huynhFeldt);
  expect.value("HF_original", got.huynhFeldtOriginal);
  expect.value("mauchly_W", got.mauchlyW);
  expect.value("mauchly_chi2", got.mauchlyChiSquared);
  expect.value("mauchly_df", got.mauchlyDf);
  expect.value("mauchly_p_chi2", got.mauchlyP);
  expect.value("GG", got.greenhouseGeisser);
}

void expectMixed(const MixedAnova& got, const nlohmann::json& e, double tolerance) {
  const Expect expect{e, tolerance};
  expect.value("SS_group", got.group->ss);
  expect.value("SS_subj", got.group->ssError);
  expect.value("SS_time_typeIII", got.time.ss);
  expect.value("SS_time_typeII", got.timeTypeII.ss);
  expect.value("SS_int", got.interaction->ss);
  expect.value("SS_err", got.time.ssError);
  expect.value("df_err", got.time.dfError);
  expect.value("F_group", got.group->f);
  expect.value("F_time_III", got.time.f);
  expect.value("F_time_II", got.timeTypeII.f);
  expect.value("F_int", got.interaction->f);
  expect.value("p_group", got.group->p);
  expect.value("p_time_III", got.time.p);
  expect.value("p_time_II", got.timeTypeII.p);
  expect.value("p_int", got.interaction->p);
  expect.value("p_time_III_GG", *got.time.pGreenhouseGeisser);
  expect.value("p_int_GG", *got.interaction->pGreenhouseGeisser);
  expect.value("p_time_III_HF", *got.time.pHuynhFeldt);
  expect.value("p_int_HF", *got.interaction->pHuynhFeldt);
  expect.value("ges_group", got.group->generalizedEtaSquared);
  expect.value("ges_time", got.time.generalizedEtaSquared);
  expect.value("ges_int", got.interaction->generalizedEtaSquared);
  expect.value("partial_eta2_time", got.time.partialEtaSquared);
  expect.value("partial_eta2_int", got.interaction->partialEtaSquared);
  expect.value("partial_eta2_group", got.group->partialEtaSquared);
  expectSphericity(got.sphericity, e.at("eps"), tolerance);
}

TEST(MixedAnova, AgreesOnUnbalancedGroupsForBothTypes) {
  const ReferenceCase c = referenceCase("groups", "mixed_anova_obrien_kaiser_phase_means");
  std::map<std::string, Groups> rows;
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < c.input.at("treatment").size(); ++i) {
    all.push_back(numbers(c.input.at("Y_pre_post_fup")[i]));
    rows[c.input.at("treatment")[i].get<std::string>()].push_back(all.back());
  }
  std::vector<NumberTable> groups;
  for (const auto& [name, trainees] : rows) {
    groups.emplace_back(trainees);
  }
  expectMixed(*mixedAnova(groups), c.expected, c.tolerance);

  const ReferenceCase one = referenceCase("groups", "rm_anova_obrien_kaiser_phase_means");
  const Outcome<MixedAnova> got = mixedAnova({NumberTable(all)});
  const Expect expect{one.expected, one.tolerance};
  expect.value("F", got->time.f);
  expect.value("p", got->time.p);
  expect.value("SS_time", got->time.ss);
  expect.value("SS_err", got->time.ssError);
  expect.value("p_GG", *got->time.pGreenhouseGeisser);
  expect.value("p_HF", *got->time.pHuynhFeldt);
  expectSphericity(got->sphericity, one.expected, one.tolerance);
  EXPECT_FALSE(got->group.has_value());
}

struct Study {
  ReferenceCase reference = referenceCase("training_study", "training_study_synthetic");
  std::vector<Groups> scores;  // group, trainee, occasion
  Study() : scores(reference.expected.at("intern_scores_g_i_t").get<std::vector<Groups>>()) {}

  [[nodiscard]] Groups occasion(std::size_t t) const {
    Groups out;
    for (const Groups& group : scores) {
      out.emplace_back();
      for (const std::vector<double>& trainee : group) {
        out.back().push_back(trainee[t]);
      }
    }
    return out;
  }
  [[nodiscard]] Groups gainsInTenths() const {
    Groups out;
    for (const Groups& group : scores) {
      out.emplace_back();
      for (const std::vector<double>& trainee : group) {
        out.back().push_back(std::round(10.0 * trainee[2]) - std::round(10.0 * trainee[0]));
      }
    }
    return out;
  }
};

TEST(GroupTests, LeaveEmptyGroupsOutAndNameTheOthersByTheirNumber) {
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

// R: car::Anova(lm(cbind(a, b, c) ~ g), idata, ~t, type = 3) with contr.sum; groups of 1, 5 and 4.
TEST(MixedAnova, TakesAGroupOfOneTrainee) {
  const NumberTable one({{3, 5, 6}});
  const NumberTable five({{1, 3, 2}, {2, 2, 4}, {1, 4, 4}, {3, 3, 6}, {2, 5, 4}});
  const NumberTable fourth({{4, 4, 5}, {5, 6, 8}, {3, 6, 6}, {4, 7, 7}});
  const Outcome<MixedAnova> got = mixedAnova({one, five, fourth});
  ASSERT_TRUE(got) << got.reason().str();
  EXPECT_NEAR(got->group->f, 8.6789242590559841, 1e-12);
  EXPECT_NEAR(got->time.f, 11.9646025793469217, 1e-12);
  EXPECT_NEAR(got->interaction->f, 0.0835543766578249, 1e-12);
  EXPECT_NEAR(*got->interaction->pGreenhouseGeisser, 0.97025320019158900, 1e-12);
}

TEST(MixedAnova, NeedsNoMoreTraineesThanContrasts) {
  // Five trainees in two groups, four occasions: three degrees of freedom for three contrasts.
  const Outcome<MixedAnova> got = mixedAnova(
      {NumberTable({{1, 3, 2, 5}, {2, 2, 4, 6}, {1, 4, 4, 7}}), NumberTable({{3, 3, 5, 4}, {2, 5, 3, 6}})});

  ASSERT_TRUE(got) << got.reason().str();
  EXPECT_DOUBLE_EQ(got->time.dfError, 9.0);
  EXPECT_GT(got->sphericity.mauchlyP, 0.0);
  EXPECT_LE(got->sphericity.mauchlyP, 1.0);
  EXPECT_GE(*got->time.pHuynhFeldt, got->time.p);
  EXPECT_FALSE(
      mixedAnova({NumberTable({{1, 3, 2, 5}, {2, 2, 4, 6}}), NumberTable({{3, 3, 5, 4}, {2, 5, 3, 6}})}));
}

TEST(MixedAnova, OfGainsThatDifferByRoundingOnlyIsUndefined) {
  // Everybody of a group gains the same in decimals; as doubles the gains differ in the last bit.
  const std::vector<NumberTable> groups = {NumberTable({{0.1, 10.1}, {0.2, 10.2}}),
                                           NumberTable({{0.1, 10.1}, {0.1, 10.1}}),
                                           NumberTable({{0.2, 10.1}, {0.2, 10.1}})};
  EXPECT_FALSE(mixedAnova(groups));
  EXPECT_FALSE(pairedT(std::vector<double>{5.1, 6.2, 7.3}, std::vector<double>{3.1, 4.2, 5.3}));
  const Groups before = {{0.1, 0.2, 0.3}, {0.1, 0.2, 0.4}};
  const Groups after = {{1.1, 1.2, 1.3}, {2.1, 2.2, 2.4}};
  EXPECT_FALSE(ancova(before, after));
}

TEST(MixedAnova, KeepsASmallErrorBesideLargeDifferencesBetweenTrainees) {
  // Trainees lie a million apart, and what is left within them is a tenth: both are known.
  std::vector<std::vector<double>> rows;
  std::vector<std::vector<double>> near;
  const std::vector<std::vector<double>> left = {
      {0.1, -0.1, 0.0}, {-0.1, 0.1, 0.1}, {0.0, 0.2, -0.1}, {0.1, 0.0, 0.1}};
  for (std::size_t i = 0; i < left.size(); ++i) {
    rows.emplace_back();
    near.emplace_back();
    for (const double e : left[i]) {
      rows.back().push_back(1e6 * static_cast<double>(i) + e);
      near.back().push_back(static_cast<double>(i) + e);
    }
  }
  const Outcome<MixedAnova> far = mixedAnova({NumberTable(rows)});
  const Outcome<MixedAnova> close = mixedAnova({NumberTable(near)});
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->sphericity.greenhouseGeisser, close->sphericity.greenhouseGeisser, 1e-6);
  EXPECT_NEAR(far->time.f, close->time.f, 1e-6 * close->time.f);
}

TEST(MixedAnova, AgreesOnTheSyntheticTrainingStudy) {
  const Study study;
  std::vector<NumberTable> groups;
  for (const Groups& group : study.scores) {
    groups.emplace_back(group);
  }
  expectMixed(*mixedAnova(groups), study.reference.expected.at("mixed_anova"), study.reference.tolerance);
}

TEST(Ancova, AgreesOnTheSyntheticTrainingStudy) {
  const Study study;
  const nlohmann::json& e = study.reference.expected.at("ancova_post_on_pre");
  const Expect expect{e, study.reference.tolerance};
  const Outcome<Ancova> got = ancova(study.occasion(0), study.occasion(2));
  expect.value("slope", got->slope);
  expect.value("slope_se", got->slopeError);
  expect.value("F_group", got->group.f);
  expect.value("p_group", got->group.p);
  expect.value("resid_var", got->residualVariance);
  expect.value("slopes_homogeneity_F", got->equalSlopes->f);
  expect.value("slopes_homogeneity_p", got->equalSlopes->p);
  const char* names[] = {"1-2", "1-3", "2-3"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(
        matches(got->adjusted[i].mean, e.at("adjusted_means")[i].get<double>(), study.reference.tolerance));
    EXPECT_TRUE(
        matches(got->adjusted[i].error, e.at("adjusted_se")[i].get<double>(), study.reference.tolerance));
    const Expect pair{e.at("pairs").at(names[i]), study.reference.tolerance};
    pair.value("diff", got->pairs[i].difference);
    pair.value("se", got->pairs[i].error);
    pair.value("t", got->pairs[i].t);
    pair.value("p", got->pairs[i].p);
    pair.value("p_holm", got->pairs[i].pHolm);
  }
  EXPECT_FALSE(ancova({{1, 1}, {1, 1}}, {{2, 3}, {4, 5}}));
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
  // The trap itself: differences of doubles split ties and give another H.
  Groups noisy;
  for (std::size_t g = 0; g < 3; ++g) {
    noisy.emplace_back();
    for (const std::vector<double>& trainee : study.scores[g]) {
      noisy.back().push_back(trainee[2] - trainee[0]);
    }
  }
  EXPECT_NEAR(kruskalWallis(noisy)->h, 21.297724, 1e-5);
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

TEST(SampleDeviation, SurvivesALargeOffset) {
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
}  // namespace torsio
