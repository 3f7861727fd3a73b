// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/rank_tests.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/statistics/mean_tests.h"
#include "tests/assessment/group_cases.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
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

}  // namespace
}  // namespace torsio
