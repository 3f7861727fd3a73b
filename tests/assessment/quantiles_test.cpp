// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/quantiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using test::matches;
using test::numbers;

TEST(Quantile, FollowsAllNineRules) {
  const test::ReferenceCase rules = test::referenceCase("quantiles", "quantile_types");
  const std::vector<double> p = numbers(rules.input.at("p"));
  for (const char* data : {"n9", "n10"}) {
    const std::vector<double> values = numbers(rules.input.at(data));
    for (int type = 1; type <= 9; ++type) {
      const std::vector<double> expected = numbers(rules.expected.at(data).at("type" + std::to_string(type)));
      for (std::size_t i = 0; i < p.size(); ++i) {
        EXPECT_TRUE(matches(quantile(values, p[i], static_cast<QuantileRule>(type)).value(), expected[i],
                            rules.tolerance))
            << data << " type " << type << " p " << p[i];
      }
    }
  }
}

TEST(BoxNumbers, ReproducesTheBoxesOfExampleThree) {
  const nlohmann::json example = test::referenceCase("evaluation", "eq25_ex3_20_10_10").expected;
  constexpr double kTolerance = 1e-13;  // composites are rounded once, interpolation rounds again
  for (const char* model : {"PM", "FEM", "MSM"}) {
    std::vector<double> composites;
    for (const char* id : {"A", "B", "C"}) {
      for (const double x : numbers(example.at("models").at(model).at("rater_composites").at(id))) {
        composites.push_back(x);
      }
    }
    const nlohmann::json& expected = example.at("box").at(model);
    const std::vector<double> type7 = numbers(expected.at("type7"));

    const BoxNumbers box = boxNumbers(composites).value();

    EXPECT_EQ(box.n, 40);
    EXPECT_TRUE(matches(box.min, type7[0], kTolerance));
    EXPECT_TRUE(matches(box.q1, type7[1], kTolerance));
    EXPECT_TRUE(matches(box.median, type7[2], kTolerance));
    EXPECT_TRUE(matches(box.q3, type7[3], kTolerance));
    EXPECT_TRUE(matches(box.max, type7[4], kTolerance));
    EXPECT_TRUE(matches(box.whiskerLow, expected.at("whisker_lo").get<double>(), kTolerance));
    EXPECT_TRUE(matches(box.whiskerHigh, expected.at("whisker_hi").get<double>(), kTolerance));
    EXPECT_TRUE(matches(box.mean, expected.at("mean").get<double>(), kTolerance));
    EXPECT_TRUE(box.outliers.empty());
  }
}

TEST(BoxNumbers, ListsValuesBeyondTheWhiskersAsOutliers) {
  // Quartiles of type 7: 2.375 and 5.75, so the upper fence is 10.8125.
  const std::vector<double> values = {1.5, 2, 2, 3.5, 4, 4.5, 5, 6, 9.5, 20};

  const BoxNumbers box = boxNumbers(values).value();

  EXPECT_THAT(box.outliers, ::testing::ElementsAre(20.0));
  EXPECT_EQ(box.whiskerHigh, 9.5);
}

TEST(Quantile, IsUndefinedForNoValuesAndTheValueItselfForOne) {
  EXPECT_FALSE(quantile({}, 0.5).has_value());
  EXPECT_FALSE(boxNumbers({}).has_value());
  const std::vector<double> one = {3.25};
  for (int type = 1; type <= 9; ++type) {
    EXPECT_EQ(quantile(one, 0.9, static_cast<QuantileRule>(type)).value(), 3.25);
  }
}

}  // namespace
}  // namespace torsio
