// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/missing_marks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include <gtest/gtest.h>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/reliability.h"
#include "sim/core/random.h"

namespace torsio {
namespace {

/// Three groups of eight, five raters, complete marks.
std::vector<MarkedTrainee> study() {
  Random random(11);
  std::vector<double> severity;
  for (int r = 0; r < 5; ++r) {
    severity.push_back(0.6 * random.normal());
  }
  std::vector<MarkedTrainee> out;
  for (std::size_t i = 0; i < 24; ++i) {
    MarkedTrainee trainee;
    trainee.group = i % 3;
    const double ability = random.normal();
    const double later = 0.8 * ability + 0.7 * static_cast<double>(trainee.group) + 0.5 * random.normal();
    for (const double rater : severity) {
      trainee.before.emplace_back(4.0 + ability + rater + 0.7 * random.normal());
      trainee.after.emplace_back(5.0 + later + rater + 0.7 * random.normal());
    }
    out.push_back(std::move(trainee));
  }
  return out;
}

TEST(MixedComparison, OfCompleteMarksEqualsTheAnalysisOfCovarianceOfTheirMeans) {
  const std::vector<MarkedTrainee> trainees = study();
  const CompleteCases cases = completeCases(trainees, 3);
  const Outcome<Ancova> planned = ancova(cases.before, cases.after);
  const Outcome<MixedComparison> mixed = mixedComparison(trainees, 3);

  ASSERT_TRUE(planned && mixed);
  EXPECT_TRUE(cases.leftOut.empty());
  ASSERT_EQ(mixed->pairs.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const ModelEstimate& of = mixed->pairs[i].difference;
    EXPECT_NEAR(of.value, planned->pairs[i].difference, 1e-11);
    EXPECT_NEAR(of.error, planned->pairs[i].error, 1e-10);
    EXPECT_NEAR(of.df, planned->residualDf, 1e-7);
    EXPECT_NEAR(mixed->pairs[i].simultaneous.lower, planned->pairs[i].simultaneous.lower, 1e-8);
  }
  ASSERT_TRUE(mixed->group);
  EXPECT_NEAR(mixed->group->f, planned->group.f, 1e-9 * planned->group.f);
  EXPECT_NEAR(mixed->group->df2, planned->group.df2, 1e-6);
}

TEST(MixedComparison, AMissingMarkExcludesNobody) {
  std::vector<MarkedTrainee> trainees = study();
  trainees[4].after[1].reset();
  trainees[9].before[0].reset();
  trainees[10].after.assign(5, std::nullopt);

  const Outcome<MixedComparison> mixed = mixedComparison(trainees, 3);
  ASSERT_TRUE(mixed);
  EXPECT_EQ(mixed->trainees, 23U);
  EXPECT_EQ(mixed->marks, 23U * 5U - 1U);
  EXPECT_EQ(completeCases(trainees, 3).leftOut, std::vector<std::size_t>{10});
  const std::vector<MissingCount> missing = missingMarks(trainees);
  EXPECT_EQ(missing[4].after, 1U);
  EXPECT_EQ(missing[9].before, 1U);
  EXPECT_EQ(missing[10].after, 5U);
  EXPECT_EQ(missing[0].before + missing[0].after, 0U);
}

TEST(MixedComparison, IsUndefinedWithAReason) {
  std::vector<MarkedTrainee> trainees = study();
  EXPECT_FALSE(mixedComparison({}, 3));
  EXPECT_FALSE(mixedComparison(trainees, 1));
  for (MarkedTrainee& trainee : trainees) {
    trainee.after = {trainee.after[0]};
  }
  EXPECT_EQ(mixedComparison(trainees, 3).reason().str(), "there are fewer than two raters");
  trainees = study();
  for (std::size_t i = 0; i < trainees.size(); ++i) {
    for (std::size_t r = 0; r < 5; ++r) {
      if (r != i % 5) {
        trainees[i].after[r].reset();
      }
    }
  }
  EXPECT_FALSE(mixedComparison(trainees, 3));  // one mark each
  trainees = study();
  for (MarkedTrainee& trainee : trainees) {
    trainee.before.assign(5, 6.0);
  }
  EXPECT_EQ(mixedComparison(trainees, 3).reason().str(), "the scores before do not vary within groups");
  trainees = study();
  for (MarkedTrainee& trainee : trainees) {
    trainee.after.assign(5, *meanMark(trainee.before));
  }
  EXPECT_FALSE(mixedComparison(trainees, 3));  // no residual
}

/// Three groups of ten, five raters, every seventh mark missing, strongly skewed.
std::vector<MarkedTrainee> skewedStudy(std::uint64_t seed) {
  Random random(seed);
  const auto draw = [&] { return -std::log(1.0 - random.uniform()) - 1.0; };
  std::vector<double> severity;
  for (int r = 0; r < 5; ++r) {
    severity.push_back(0.5 * draw());
  }
  std::vector<MarkedTrainee> out;
  for (std::size_t i = 0; i < 30; ++i) {
    MarkedTrainee trainee;
    trainee.group = i % 3;
    const double score = draw();
    const double later = 0.8 * score + 0.5 * draw();
    for (const double rater : severity) {
      trainee.before.emplace_back(score);
      const double mark = later + rater + 0.7 * draw();
      trainee.after.push_back(random.uniform() < 0.15 ? std::nullopt : std::optional(mark));
    }
    out.push_back(std::move(trainee));
  }
  return out;
}

// Regression: a variance near 0 that had to grow again stopped the others.
TEST(MixedComparison, ConvergesIfAVarianceComesNearZeroOnTheWay) {
  for (const auto& [seed, trainees, residual, criterion] :
       {std::tuple{195U, 0.2723512733, 0.6469552655, 338.6851},
        std::tuple{700U, 0.1084420976, 0.6572546387, 325.0764}}) {
    const Outcome<MixedComparison> got = mixedComparison(skewedStudy(seed), 3);
    ASSERT_TRUE(got) << seed << ": " << got.reason().str();
    EXPECT_NEAR(got->varianceTrainees, trainees, 1e-7);  // lme4: lmer(y ~ 0 + g + x + (1 | s) + (1 | r))
    EXPECT_EQ(got->varianceRaters, 0.0);
    EXPECT_NEAR(got->varianceResidual, residual, 1e-7);
    EXPECT_NEAR(got->criterion, criterion, 1e-4);
  }
}

TEST(MixedComparison, LeavesAnEmptyGroupOut) {
  std::vector<MarkedTrainee> trainees = study();
  trainees[0].after[0].reset();
  const Outcome<MixedComparison> three = mixedComparison(trainees, 3);
  for (MarkedTrainee& trainee : trainees) {
    trainee.group += trainee.group > 0 ? 1 : 0;  // the second of four is empty
  }
  const Outcome<MixedComparison> four = mixedComparison(trainees, 4);
  ASSERT_TRUE(three && four);
  EXPECT_EQ(four->groups, (std::vector<std::size_t>{0, 2, 3}));
  ASSERT_EQ(four->pairs.size(), 3U);
  EXPECT_EQ(four->pairs[2].first, 2U);
  EXPECT_EQ(four->pairs[2].second, 3U);
  EXPECT_EQ(four->pairs[2].difference.value, three->pairs[2].difference.value);
  EXPECT_EQ(four->group->f, three->group->f);
}

TEST(MixedComparison, IsInvariantToOffsetAndUnit) {
  std::vector<MarkedTrainee> trainees = study();
  trainees[4].after[1].reset();
  std::vector<MarkedTrainee> moved = trainees;
  for (MarkedTrainee& trainee : moved) {
    for (auto* marks : {&trainee.before, &trainee.after}) {
      for (std::optional<double>& mark : *marks) {
        mark = mark ? std::optional(1000.0 * *mark + 1e6) : std::nullopt;
      }
    }
  }
  const Outcome<MixedComparison> here = mixedComparison(trainees, 3);
  const Outcome<MixedComparison> there = mixedComparison(moved, 3);
  ASSERT_TRUE(here && there);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(there->pairs[i].difference.value, 1000.0 * here->pairs[i].difference.value, 1e-6);
    EXPECT_NEAR(there->pairs[i].difference.p, here->pairs[i].difference.p, 1e-9);
  }
}

TEST(MissingBounds, ContainTheResultOfTheCompleteMarks) {
  const std::vector<MarkedTrainee> whole = study();
  std::vector<MarkedTrainee> holed = whole;
  holed[3].after.assign(5, std::nullopt);
  holed[7].after[2].reset();
  const CompleteCases cases = completeCases(whole, 3);
  const Outcome<Ancova> truth = ancova(cases.before, cases.after);
  ASSERT_TRUE(truth);
  const std::vector<MissingBounds> bounds = missingBounds(holed, 3, 0.0, 12.0);
  ASSERT_EQ(bounds.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(bounds[i].worst && bounds[i].best);
    EXPECT_LE(bounds[i].worst->difference, truth->pairs[i].difference + 1e-12);
    EXPECT_GE(bounds[i].best->difference, truth->pairs[i].difference - 1e-12);
  }
}

IncompleteRatings byRater(const NumberTable& table) {
  IncompleteRatings out(table.columns());
  for (std::size_t r = 0; r < table.columns(); ++r) {
    for (std::size_t i = 0; i < table.rows(); ++i) {
      out[r].emplace_back(table.at(i, r));
    }
  }
  return out;
}

TEST(IncompleteReliability, OfCompleteMarksEqualsTheIntraclassCorrelation) {
  // Shrout and Fleiss 1979.
  const NumberTable table(
      {{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}});
  const Outcome<IccResult> icc = intraclassCorrelation(table);
  const Outcome<IncompleteReliability> reml = incompleteReliability(byRater(table));
  ASSERT_TRUE(icc && reml);
  EXPECT_NEAR(reml->single, icc->agreementSingle.estimate, 1e-11);
  EXPECT_NEAR(reml->mean, icc->agreementMean.estimate, 1e-11);
  EXPECT_NEAR(reml->varianceRaters, icc->varianceRaters, 1e-10);
  EXPECT_NEAR(reml->semMean, icc->semMean, 1e-11);
  EXPECT_NEAR(icc->semMean, icc->semAgreement / 2.0, 1e-15);
}

TEST(IncompleteReliability, HoldsANegativeComponentAtZero) {
  const NumberTable table(
      {{1, 2, 3}, {2, 3, 1}, {3, 1, 2}, {7, 8, 9}, {8, 9, 7}, {9, 7, 8}});  // raters alike
  const Outcome<IncompleteReliability> reml = incompleteReliability(byRater(table));
  ASSERT_TRUE(reml);
  EXPECT_EQ(reml->varianceRaters, 0.0);
  EXPECT_GT(reml->varianceTargets, 1.0);
}

TEST(SeparateSlopes, TheRegionEndsWhereTheTestDoes) {
  const Groups before{{2, 3, 4, 5, 6, 7, 8}, {2, 3, 4, 5, 6, 7, 8}};
  const Groups after{{3.1, 3.8, 5.2, 5.9, 7.1, 8.2, 8.8}, {6.2, 6.1, 6.4, 6.2, 6.6, 6.5, 6.4}};
  ASSERT_LT(ancova(before, after)->equalSlopes->p, kSlopesDiffer);
  const Outcome<SeparateSlopes> first = separateSlopes(before, after, defaultBaselines(before));
  ASSERT_TRUE(first && first->pairs[0].region.outside);
  const Interval ends = *first->pairs[0].region.outside;
  const Outcome<SeparateSlopes> there = separateSlopes(before, after, std::vector{ends.lower, ends.upper});
  for (const AdjustedDifference& at : there->pairs[0].at) {
    EXPECT_NEAR(at.p, 0.05, 1e-12);
  }
  EXPECT_EQ(first->baselines.size(), 3U);
  EXPECT_GT(first->pairs[0].at[1].simultaneous.upper, first->pairs[0].at[1].interval.upper);
}

TEST(Equivalence, HoldsExactlyIfTheIntervalIsWithinTheMargin) {
  const double edge = 0.4 + tQuantile(0.95, 20.0) * 0.2;  // upper end of the 90 % interval
  EXPECT_NEAR(equivalence(0.4, 0.2, 20.0, edge).p, 0.05, 1e-12);
  EXPECT_LT(equivalence(0.4, 0.2, 20.0, edge + 0.01).p, 0.05);
  EXPECT_GT(equivalence(-0.4, 0.2, 20.0, edge - 0.01).p, 0.05);
  EXPECT_NEAR(equivalence(-0.4, 0.2, 20.0, edge).interval.lower, -edge, 1e-12);
}

TEST(Permutation, BeyondCountingIsRandomWithAStatedError) {
  Random random(5);
  std::vector<std::int64_t> x;
  std::vector<std::int64_t> y;
  for (int i = 0; i < 12; ++i) {
    x.push_back(static_cast<std::int64_t>(random.bounded(60)));
    y.push_back(15 + static_cast<std::int64_t>(random.bounded(60)));
  }
  const Outcome<PermutationTest> exact = permutationTest(x, y);
  MonteCarlo some;
  some.mostAdditions = 1;
  const Outcome<PermutationTest> drawn = permutationTest(x, y, some);
  ASSERT_TRUE(exact && drawn);
  EXPECT_TRUE(exact->exact);
  EXPECT_FALSE(drawn->exact);
  EXPECT_EQ(exact->error, 0.0);
  EXPECT_GT(drawn->error, 0.0);
  EXPECT_NEAR(drawn->p, exact->p, 4.0 * drawn->error);

  std::vector<std::int64_t> many;
  for (int i = 0; i < 100; ++i) {
    many.push_back(static_cast<std::int64_t>(random.bounded(41)) - 17);
  }
  const Outcome<PermutationTest> paired = pairedPermutationTest(many);
  ASSERT_TRUE(paired);
  EXPECT_FALSE(paired->exact);
  const std::vector<double> differences(many.begin(), many.end());
  double squares = 0.0;
  double sum = 0.0;
  for (const double d : differences) {
    squares += d * d;
    sum += d;
  }
  EXPECT_NEAR(paired->p, normalTwoSided(sum / std::sqrt(squares)), 0.01);  // the limit for many signs
  EXPECT_EQ(pairedPermutationTest(many)->p, paired->p);                    // determined by the seed
}

TEST(SignedRank, IsExactForAThousandPairs) {
  for (const int n : {54, 100, 1'000}) {
    std::vector<double> rising(static_cast<std::size_t>(n));
    std::iota(rising.begin(), rising.end(), 1.0);
    const Outcome<SignedRank> all = signedRank(rising);
    ASSERT_TRUE(all && all->exact) << n;
    EXPECT_NEAR(all->pTwoSided / std::ldexp(1.0, 1 - n), 1.0, 1e-12) << n;
    rising.front() = -1.0;  // the two most extreme sums of each end
    EXPECT_NEAR(signedRank(rising)->pTwoSided / std::ldexp(1.0, 2 - n), 1.0, 1e-12) << n;
  }
}

TEST(SignedRank, DoesNotDependOnTheOrderOfThePairs) {
  Random random(5);
  std::vector<double> differences;
  for (int i = 0; i < 1'200; ++i) {  // too many for exact counting
    differences.push_back(std::round(20.0 * random.normal()) + 1.5);
  }
  const double p = signedRank(differences)->pTwoSided;
  EXPECT_FALSE(signedRank(differences)->exact);
  std::reverse(differences.begin(), differences.end());
  EXPECT_EQ(signedRank(differences)->pTwoSided, p);
}

TEST(SignedRank, OfManyPairsHasItsMedianAndAnExactP) {
  Random random(8);
  std::vector<double> differences;
  std::vector<double> means;
  for (int i = 0; i < 120; ++i) {
    differences.push_back(std::round(40.0 * random.normal()) + 5.5);
  }
  for (std::size_t i = 0; i < differences.size(); ++i) {
    for (std::size_t j = i; j < differences.size(); ++j) {
      means.push_back(0.5 * (differences[i] + differences[j]));
    }
  }
  const Outcome<SignedRank> test = signedRank(differences);
  ASSERT_TRUE(test);
  EXPECT_TRUE(test->exact);
  EXPECT_EQ(test->hodgesLehmann, medianOf(means));
  const double n = 120.0;
  const double z = (test->v - n * (n + 1.0) / 4.0) / std::sqrt(n * (n + 1.0) * (2.0 * n + 1.0) / 24.0);
  EXPECT_NEAR(test->pTwoSided, normalTwoSided(z), 0.005);
}

TEST(MannWhitney, HasTheMedianOfAllDifferencesOfLargeGroups) {
  Random random(9);
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> differences;
  for (int i = 0; i < 60; ++i) {
    x.push_back(random.normal());
    y.push_back(random.normal() + 0.3);
  }
  for (const double a : x) {
    for (const double b : y) {
      differences.push_back(a - b);
    }
  }
  EXPECT_EQ(mannWhitney(x, y)->hodgesLehmann, medianOf(differences));
}

}  // namespace
}  // namespace torsio
