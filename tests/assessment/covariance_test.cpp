// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/statistics/ancova.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/mixed_anova.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using test::Expect;
using test::matches;
using test::numbers;
using test::ReferenceCase;
using test::referenceCase;
using test::Study;

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

// R: car::Anova(lm(cbind(a, b, c) ~ g), idata, ~t, type = 3) with contr.sum; groups of 1, 5 and 4.
TEST(MixedAnova, AcceptsAGroupOfOneTrainee) {
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

TEST(MixedAnova, OfGainsThatDifferOnlyByRoundingIsUndefined) {
  // Within a group all decimal gains are equal; as doubles they differ in the last bit.
  const std::vector<NumberTable> groups = {NumberTable({{0.1, 10.1}, {0.2, 10.2}}),
                                           NumberTable({{0.1, 10.1}, {0.1, 10.1}}),
                                           NumberTable({{0.2, 10.1}, {0.2, 10.1}})};
  EXPECT_FALSE(mixedAnova(groups));
  EXPECT_FALSE(pairedT(std::vector<double>{5.1, 6.2, 7.3}, std::vector<double>{3.1, 4.2, 5.3}));
  const Groups before = {{0.1, 0.2, 0.3}, {0.1, 0.2, 0.4}};
  const Groups after = {{1.1, 1.2, 1.3}, {2.1, 2.2, 2.4}};
  EXPECT_FALSE(ancova(before, after));
}

TEST(MixedAnova, PreservesASmallErrorBesideLargeDifferencesBetweenTrainees) {
  // Trainees are a million apart, with residuals of a tenth: both are recovered.
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

// R: e <- resid(m); V <- b %*% t(X) %*% diag(e^2 / (1 - hatvalues(m))^2) %*% X %*% b with b = (X'X)^-1 of
// lm(after ~ 0 + group + before); degrees of freedom sum(diag(A %*% M))^2 / sum(diag(A %*% M %*% A %*% M))
// with M <- diag(15) - X %*% b %*% t(X), A <- diag(w^2 / diag(M)^2) and w the weights of a difference;
// factors of p.adjust(p, "holm").
TEST(Covariance, ErrorsThatAllowForUnequalSpreadAreThoseOfHc3) {
  const Groups before{{3.1, 4.0, 3.6, 5.2, 4.4}, {3.9, 4.8, 2.7, 4.1, 5.0}, {3.3, 4.6, 4.2, 3.8, 5.1}};
  const Groups after{{5.0, 6.4, 5.1, 9.8, 6.0}, {5.6, 5.9, 5.2, 5.7, 6.1}, {4.4, 5.2, 5.0, 4.7, 5.5}};
  const Ancova found = ancova(before, after).value();
  const UnequalSpread& spread = found.spread;
  ASSERT_EQ(spread.pairs.size(), 3U);
  const double error[] = {0.881055665483344, 0.838296109156015, 0.424700877868748};
  const double df[] = {7.214689816239598, 7.535667323001006, 7.488004755592996};
  const double p[] = {0.3923325981244809, 0.0875155287977038, 0.0846143825802002};
  const double pHolm[] = {0.3923325981244809, 0.2538431477405766, 0.2538431477405766};
  const double lower[] = {-1.2693236089353626, -0.9032079274739921, -0.4593155720795106};
  const double upper[] = {2.872403691070892, 4.193988214948329, 2.147015777418317};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(spread.pairs[i].difference, found.pairs[i].difference);
    EXPECT_NEAR(spread.pairs[i].error, error[i], 1e-12);
    EXPECT_NEAR(spread.pairs[i].df, df[i], 1e-11);
    EXPECT_NEAR(spread.pairs[i].p, p[i], 1e-12);
    EXPECT_NEAR(spread.pairs[i].pHolm, pHolm[i], 1e-12);
    EXPECT_NEAR(spread.pairs[i].asHolm.lower, lower[i], 1e-10);
    EXPECT_NEAR(spread.pairs[i].asHolm.upper, upper[i], 1e-10);
  }
  EXPECT_NEAR(spread.test->p, 0.428374520316705, 1e-12);
  EXPECT_NEAR(spread.largest, 1.255265557227579, 1e-12);
  EXPECT_NEAR(spread.smallest, 0.296912132798017, 1e-12);
}

TEST(Covariance, SomebodyAloneInAGroupHasNoErrorOfHc3) {
  const Ancova found = ancova({{3.1, 4.0, 3.6}, {3.9}}, {{5.0, 6.4, 5.1}, {5.6}}).value();
  EXPECT_TRUE(found.spread.pairs.empty());
  EXPECT_EQ(found.pairs.size(), 1U);
}

TEST(Covariance, AnIntervalExcludesZeroExactlyWhereItsAdjustedPIsBelowFivePercent) {
  std::uint64_t state = 7;
  const auto draw = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  int below = 0;
  for (int round = 0; round < 200; ++round) {
    Groups before(4);
    Groups after(4);
    for (std::size_t g = 0; g < 4; ++g) {
      for (int i = 0; i < 6; ++i) {
        before[g].push_back(3.0 + draw());
        after[g].push_back(5.0 + draw() + 0.25 * static_cast<double>(g));
      }
    }
    const Ancova found = ancova(before, after).value();
    for (const std::vector<AdjustedDifference>& pairs : {found.pairs, found.spread.pairs}) {
      for (const AdjustedDifference& pair : pairs) {
        EXPECT_EQ(pair.pHolm<0.05, pair.asHolm.lower> 0.0 || pair.asHolm.upper < 0.0) << pair.pHolm;
        below += pair.pHolm < 0.05 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(below, 200);
}

}  // namespace
}  // namespace torsio
