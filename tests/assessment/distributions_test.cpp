// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/distributions.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/statistics/power.h"
#include "assessment/statistics/resampling.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using test::matches;
using test::numbers;
using test::ReferenceCase;
using test::referenceCase;

double valueOf(const std::string& f, const std::vector<double>& a) {
  if (f == "t_cdf" && a[0] < 0.0) {
    return 0.5 * tTwoSided(a[0], a[1]);
  }
  if (f == "t_quantile") {
    return tQuantile(a[0], a[1]);
  }
  if (f == "F_sf") {
    return fUpper(a[0], a[1], a[2]);
  }
  if (f == "F_quantile") {
    return fQuantile(a[0], a[1], a[2]);
  }
  if (f == "chi2_sf") {
    return chiSquaredUpper(a[0], a[1]);
  }
  if (f == "norm_quantile") {
    return normalQuantile(a[0]);
  }
  if (f == "norm_sf") {
    return normalUpper(a[0]);
  }
  if (f == "nct_cdf") {
    return noncentralTCdf(a[0], a[1], a[2]);
  }
  if (f == "ncF_cdf") {
    return noncentralFCdf(a[0], a[1], a[2], a[3]);
  }
  if (f == "tukey_sf") {
    return StudentizedRange(static_cast<int>(a[1])).upper(a[0], a[2]);
  }
  if (f == "tukey_quantile") {
    return StudentizedRange(static_cast<int>(a[1])).quantile(a[0], a[2]);
  }
  throw std::runtime_error("unknown function " + f);
}

TEST(Distributions, AgreeWithReferenceProgramsAndHighPrecisionValues) {
  const ReferenceCase c = referenceCase("distributions", "distributions");
  for (const nlohmann::json& row : c.expected) {
    const auto f = row.at("f").get<std::string>();
    const std::vector<double> args = row.at("args").is_array()
                                         ? numbers(row.at("args"))
                                         : std::vector<double>{row.at("args").get<double>()};
    const double expected = row.contains("exact") ? row.at("exact").get<double>() : row.at("R").get<double>();
    EXPECT_TRUE(matches(valueOf(f, args), expected, c.tolerance)) << f;
  }
}

TEST(StudentizedRange, OfTwoMeansIsStudentsTForEveryDegreeOfFreedom) {
  StudentizedRange range(2);
  for (const double df : {1.0, 1.1, 1.5, 1.99, 2.0, 3.7, 30.0, 2000.0}) {
    for (const double q : {0.02, 0.5, 1.7, 4.0, 15.0, 80.0}) {
      const double exact = tTwoSided(q / std::sqrt(2.0), df);  // the range of two is sqrt(2) |t|
      EXPECT_NEAR(range.upper(q, df), exact, 1e-9 * exact + 1e-14) << q << " with " << df;
    }
    EXPECT_NEAR(range.quantile(0.95, df), std::sqrt(2.0) * tQuantile(0.975, df),
                1e-8 * range.quantile(0.95, df));
  }
}

TEST(StudentizedRange, OfManyMeansWithFewDegreesOfFreedomKeepsItsDigits) {
  // Both integrals over panels of width 0.05 with 20 points, without interpolation.
  EXPECT_NEAR(StudentizedRange(60).upper(20.0, 1.7), 0.07592678434341313, 1e-12);
  EXPECT_NEAR(StudentizedRange(5).upper(10.0, 1.3), 0.12679881359947826, 1e-12);
  EXPECT_NEAR(StudentizedRange(3).upper(3.5, 1.0), 0.35987526963605143, 1e-12);
}

TEST(Power, AgreesForTAnovaAndIntraclassCorrelation) {
  const ReferenceCase c = referenceCase("groups", "power");
  const auto expectValue = [&](const char* name, double got) {
    EXPECT_TRUE(matches(got, c.expected.at(name).get<double>(), c.tolerance)) << name;
  };
  expectValue("t_n10_d08", powerTwoSampleT(10, 0.8));
  expectValue("t_n20_d08", powerTwoSampleT(20, 0.8));
  expectValue("t_d05_80", sizeTwoSampleT(0.5, 0.8));
  expectValue("t_d08_80", sizeTwoSampleT(0.8, 0.8));
  expectValue("t_n10_80_d", detectableTwoSampleT(10, 0.8));
  expectValue("paired_n10_80_d", detectablePairedT(10, 0.8));
  expectValue("aov_k3_n10_f04", powerAnova(3, 10, 0.4));
  expectValue("aov_k3_f04_80", sizeAnova(3, 0.4, 0.8));
  expectValue("aov_k3_f025_80", sizeAnova(3, 0.25, 0.8));
  const nlohmann::json& icc = c.expected.at("bonett_icc");
  EXPECT_TRUE(matches(sizeIccWidth(0.7, 10, 0.2), icc.at("rho07_k10_w02").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(sizeIccWidth(0.7, 3, 0.2), icc.at("rho07_k3_w02").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(sizeIccWidth(0.8, 2, 0.2), icc.at("rho08_k2_w02").get<double>(), c.tolerance));
  EXPECT_DOUBLE_EQ(sizeWithCovariate(25.0, 0.6), 16.0);
}

TEST(Bootstrap, AgreesWithTheEnumerationOfAllResamples) {
  const ReferenceCase c = referenceCase("groups", "bootstrap_exact_enumeration");
  const std::vector<double> data = numbers(c.input.at("data"));
  const ResampledStatistic mean = [&](std::span<const std::size_t> rows) {
    double sum = 0.0;
    for (const std::size_t row : rows) {
      sum += data[row];
    }
    return sum / static_cast<double>(rows.size());
  };
  const Outcome<Bootstrap> got = bootstrap(data.size(), mean, {.everyResample = true});
  const auto expectValue = [&](const char* name, double value) {
    EXPECT_TRUE(matches(value, c.expected.at(name).get<double>(), c.tolerance)) << name;
  };
  const auto expectInterval = [&](const char* name, const Interval& value) {
    EXPECT_TRUE(matches(value.lower, c.expected.at(name)[0].get<double>(), c.tolerance)) << name;
    EXPECT_TRUE(matches(value.upper, c.expected.at(name)[1].get<double>(), c.tolerance)) << name;
  };
  EXPECT_EQ(got->resamples, 3125);
  expectValue("theta", got->estimate);
  expectValue("boot_se", got->error);
  expectValue("z0_half", got->z0);
  expectValue("a", got->acceleration);
  expectInterval("perc", got->percentile);
  expectInterval("basic", got->basic);
  expectInterval("bca_levels", got->bcaLevels);
  expectInterval("bca", got->bca);
}

TEST(Bootstrap, IsReproducibleAndUndefinedForAConstant) {
  const std::vector<double> data = {1, 4, 2, 8, 5, 7};
  const ResampledStatistic mean = [&](std::span<const std::size_t> rows) {
    double sum = 0.0;
    for (const std::size_t row : rows) {
      sum += data[row];
    }
    return sum / static_cast<double>(rows.size());
  };
  EXPECT_EQ(bootstrap(6, mean, {.seed = 3})->bca.lower, bootstrap(6, mean, {.seed = 3})->bca.lower);
  EXPECT_FALSE(bootstrap(6, [](std::span<const std::size_t>) { return 1.0; }));
  const auto huge = [](std::span<const std::size_t> rows) { return rows.front() == 0 ? 1e308 : -1e308; };
  EXPECT_FALSE(bootstrap(6, huge));
}

double medianOfRows(const std::vector<double>& data, std::span<const std::size_t> rows) {
  std::vector<double> values;
  for (const std::size_t row : rows) {
    values.push_back(data[row]);
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

TEST(Bootstrap, OfValuesThatOverflowOnlyInAResampleIsUndefined) {
  const std::vector<double> data = {9, 4, -1e308,
                                    8};  // the median of all four, and of any three, is not huge
  const auto median = [&](std::span<const std::size_t> rows) { return medianOfRows(data, rows); };
  ASSERT_TRUE(jackknife(data.size(), median));
  EXPECT_FALSE(bootstrap(data.size(), median, {.seed = 1, .resamples = 99}));
}

TEST(Bootstrap, OfAMedianAmongEqualsHasNoAccelerationButAnInterval) {
  const std::vector<double> data = {1, 4, 5, 5, 5, 5, 6, 9};  // without any one of them the median is still 5
  const auto median = [&](std::span<const std::size_t> rows) { return medianOfRows(data, rows); };
  EXPECT_EQ(jackknife(data.size(), median)->error, 0.0);
  const Outcome<Bootstrap> got = bootstrap(data.size(), median);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->estimate, 5.0);
  EXPECT_EQ(got->acceleration, 0.0);
  EXPECT_LE(got->bca.lower, 5.0);
  EXPECT_GE(got->bca.upper, 5.0);
  EXPECT_LT(got->bca.lower, got->bca.upper);
}

TEST(Jackknife, AgreesOnTheLawSchoolData) {
  const ReferenceCase c = referenceCase("groups", "jackknife_law_school");
  const std::vector<double> x = numbers(c.input.at("LSAT"));
  const std::vector<double> y = numbers(c.input.at("GPA"));
  const Outcome<Correlation> r = pearson(x, y);
  EXPECT_TRUE(matches(r->r, c.expected.at("r").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(r->fisherInterval->lower, c.expected.at("fisher_ci")[0].get<double>(), c.tolerance));
  EXPECT_TRUE(matches(r->fisherInterval->upper, c.expected.at("fisher_ci")[1].get<double>(), c.tolerance));
  const Outcome<Jackknife> got = jackknife(x.size(), [&](std::span<const std::size_t> rows) {
    std::vector<double> u;
    std::vector<double> v;
    for (const std::size_t row : rows) {
      u.push_back(x[row]);
      v.push_back(y[row]);
    }
    return pearson(u, v)->r;
  });
  EXPECT_TRUE(matches(got->error, c.expected.at("jack_se").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->acceleration, c.expected.at("a").get<double>(), c.tolerance));
}

TEST(NoncentralityOfT, IsContinuousAcrossItsTwoFormulas) {
  for (const double df : {3.0, 18.0, 200.0}) {
    for (const double p : {0.025, 0.975}) {
      const double below = noncentralityOfT(4'999.0, df, p);
      const double above = noncentralityOfT(5'001.0, df, p);
      EXPECT_NEAR(above / below, 5'001.0 / 4'999.0, 1e-7) << df << " " << p;
      EXPECT_NEAR(noncentralityOfT(-5'001.0, df, 1.0 - p), -above, 1e-9 * above);
    }
  }
  EXPECT_GT(noncentralityOfT(1e16, 10.0, 0.025), 1e15);  // groups that hardly vary and are far apart
}

}  // namespace
}  // namespace torsio
