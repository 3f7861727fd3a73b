// SPDX-License-Identifier: GPL-3.0-or-later
// Reference values: R 4.2.2. Fixed centres: lm(after ~ 0 + group + x + site) with HC3 and the degrees of
// freedom of Bell and McCaffrey; random ones: lmerTest::lmer(after ~ 0 + group + x + (1 | site)),
// contest1D(), x being the score before less its mean; heterogeneity: lm(after ~ 0 + site:group + before),
// then uniroot() of Cochran's Q.
#include "assessment/statistics/site_comparison.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/statistics/site_heterogeneity.h"

namespace torsio {
namespace {

/// Centres of unequal size: `vary` is the range of the effect of the training, `level` that of the scores.
std::vector<SiteTrainee> generated(std::size_t sites, const std::vector<std::size_t>& sizes, double vary,
                                   double level) {
  std::int64_t state = 12345;
  const auto uniform = [&] {
    state = 16807 * state % 2147483647;
    return static_cast<double>(state) / 2147483647.0;
  };
  constexpr std::array kEffects{0.0, 0.8, 0.3};
  std::vector<SiteTrainee> out;
  for (std::size_t s = 0; s < sites; ++s) {
    const double shift = level * (2.0 * uniform() - 1.0);
    const double effect = vary * (2.0 * uniform() - 1.0);
    for (std::size_t g = 0; g < 3; ++g) {
      for (std::size_t i = 0; i < sizes[(s + g) % sizes.size()]; ++i) {
        const double before = 3.0 + 2.0 * uniform();
        const double after = 1.0 + 0.7 * before + shift + kEffects[g] + effect * static_cast<double>(g) +
                             1.2 * (2.0 * uniform() - 1.0);
        out.push_back({g, s, before, after});
      }
    }
  }
  return out;
}

std::vector<SiteTrainee> six() {
  return generated(6, {4, 6, 5, 7}, 0.8, 1.0);
}
std::vector<SiteTrainee> three() {
  return generated(3, {5, 3, 6}, 0.2, 0.5);
}

using Expected = std::array<double, 4>;  // difference, error, degrees of freedom, p

void expectPairs(const SiteComparison& found, const std::array<Expected, 3>& expected, double within) {
  ASSERT_EQ(found.pairs.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const AdjustedDifference& pair = found.pairs[i];
    const Expected got{pair.difference, pair.error, pair.df, pair.p};
    for (std::size_t k = 0; k < got.size(); ++k) {
      EXPECT_NEAR(got[k], expected[i][k], within * std::abs(expected[i][k])) << i << ", " << k;
    }
    EXPECT_EQ(pair.pHolm<0.05, pair.asHolm.lower> 0.0 || pair.asHolm.upper < 0.0);
  }
}

TEST(SiteComparison, FewCentresHaveLevelsOfTheirOwn) {
  EXPECT_EQ(siteTermFor(4), SiteTerm::kFixed);
  EXPECT_EQ(siteTermFor(5), SiteTerm::kRandom);
  const Outcome<SiteComparison> found = compareWithinSites(three(), SiteTerm::kFixed);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->trainees, 42U);
  EXPECT_EQ(found->sites, 3U);
  expectPairs(*found,
              {{{-0.893581533032, 0.340098262019, 22.0870275858, 0.0153508867005},
                {-0.683615992063, 0.291528529318, 21.818276061, 0.0285433981823},
                {0.209965540969, 0.311741197544, 21.5300685944, 0.50777980361}}},
              1e-9);
}

TEST(SiteComparison, FromFiveCentresOnTheyAreRandom) {
  const Outcome<SiteComparison> found = compareWithinSites(six(), SiteTerm::kRandom);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->siteVariance, 0.941015281256, 1e-6);
  EXPECT_NEAR(found->residualVariance, 0.678824923285, 1e-6);
  expectPairs(*found,
              {{{-0.912809588578, 0.20923256555, 90.1766446576, 3.40968731e-05},
                {-0.149974939083, 0.2053497977, 90.0564295181, 0.467078770493},
                {0.762834649495, 0.203420774476, 90.1644149886, 0.00031201488895}}},
              2e-6);
}

TEST(SiteComparison, CentresThatAreAlikeChangeNothing) {
  std::vector<SiteTrainee> alike = generated(6, {6, 6, 6}, 0.0, 0.0);
  for (std::size_t i = 0; i < alike.size(); ++i) {
    alike[i].site = i % 6;  // whoever it is
  }
  const SiteComparison found = compareWithinSites(alike, SiteTerm::kRandom).value();
  EXPECT_LT(found.siteVariance, 0.1 * found.residualVariance);
  if (found.siteVariance == 0.0) {
    EXPECT_EQ(found.pairs[0].df, static_cast<double>(alike.size()) - 4.0);
  }
}

TEST(SiteComparison, HeterogeneityIsThatOfTheDifferencesAtEachCentre) {
  const std::vector<Heterogeneity> found = heterogeneityOfSites(six()).value();
  ASSERT_EQ(found.size(), 3U);
  // first difference, its error, Q, p, I^2, tau^2, its ends, average
  const std::array<std::array<double, 9>, 3> expected{
      {{-1.11764907067, 0.428273524676, 13.5629490373, 0.0186374215042, 0.631348611114, 0.284711839155,
        0.00945917986228, 2.54699641617, -0.977260524886},
       {-1.60298792994, 0.443570445317, 52.0033771025, 5.38618228444e-10, 0.903852398083, 1.46331933168,
        0.473132953201, 9.60541082662, -0.160459317988},
       {-0.485338859274, 0.403496954279, 21.7026364433, 0.000596314689008, 0.769613244314, 0.568549095777,
        0.117522985728, 4.27596383747, 0.805242014566}}};
  const std::array errors{0.275422533201, 0.521480169317, 0.34940238482};
  for (std::size_t i = 0; i < 3; ++i) {
    const Heterogeneity& pair = found[i];
    ASSERT_EQ(pair.sites.size(), 6U);
    const std::array<double, 9> got{
        pair.sites[0].difference, pair.sites[0].error,    pair.q,      pair.p, pair.iSquared, pair.tauSquared,
        pair.tauInterval.lower,   pair.tauInterval.upper, pair.average};
    for (std::size_t k = 0; k < got.size(); ++k) {
      EXPECT_NEAR(got[k], expected[i][k], 1e-8 * std::abs(expected[i][k])) << i << ", " << k;
    }
    constexpr double kT5 = 2.570581835636314;  // qt(0.975, 5)
    EXPECT_NEAR(pair.averageInterval.upper - pair.average, kT5 * errors[i], 1e-8);
  }
}

TEST(SiteComparison, WithoutHeterogeneityItsVarianceIsZeroAndItsIntervalBeginsThere) {
  const std::vector<Heterogeneity> found = heterogeneityOfSites(three()).value();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[1].tauSquared, 0.0);
  EXPECT_EQ(found[1].iSquared, 0.0);
  EXPECT_EQ(found[1].tauInterval.lower, 0.0);
  EXPECT_NEAR(found[1].tauInterval.upper, 0.613584686738, 1e-8);
}

TEST(SiteComparison, SaysWhyItIsUndefined) {
  std::vector<SiteTrainee> one = three();
  for (SiteTrainee& trainee : one) {
    trainee.site = 0;
  }
  EXPECT_EQ(compareWithinSites(one, SiteTerm::kFixed).reason().str(),
            "fewer than two centres have scores at both occasions");
  EXPECT_FALSE(heterogeneityOfSites(one));
  std::vector<SiteTrainee> apart = three();
  for (SiteTrainee& trainee : apart) {
    trainee.site = trainee.group;  // each centre trained one group
  }
  EXPECT_EQ(compareWithinSites(apart, SiteTerm::kFixed).reason().str(),
            "groups, centres, scores before and further factors cannot be told apart");
  EXPECT_EQ(heterogeneityOfSites(apart).reason().str(),
            "no two centres have trainees of the same two groups");
  std::vector<SiteTrainee> levels = three();
  for (SiteTrainee& trainee : levels) {
    trainee.level = trainee.group;
  }
  EXPECT_TRUE(compareWithinSites(levels, SiteTerm::kFixed));
  EXPECT_FALSE(compareWithinSites(levels, SiteTerm::kFixed, true));
}

TEST(SiteComparison, SomebodyAloneAtACentreChangesNothingIfCentresAreFixed) {
  std::vector<SiteTrainee> more = three();
  const SiteComparison before = compareWithinSites(more, SiteTerm::kFixed).value();
  more.push_back({0, 9, 4.0, 4.4});
  const SiteComparison after = compareWithinSites(more, SiteTerm::kFixed).value();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(after.pairs[i].difference, before.pairs[i].difference, 1e-12);
    EXPECT_NEAR(after.pairs[i].error, before.pairs[i].error, 1e-12);
  }
}

}  // namespace
}  // namespace torsio
